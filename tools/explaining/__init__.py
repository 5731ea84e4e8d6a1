# SPDX-License-Identifier: MIT
"""What ./lab explain and ./lab heat make of what a lab's explain program says."""
