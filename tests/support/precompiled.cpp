// SPDX-License-Identifier: MIT
// Empty: the precompiled header that all tests share needs a source file to belong to.
