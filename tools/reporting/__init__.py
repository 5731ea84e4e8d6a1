# SPDX-License-Identifier: MIT
"""What ./lab report measures, draws and writes."""
