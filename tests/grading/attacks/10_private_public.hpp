// SPDX-License-Identifier: MIT
#pragma once
#define private public
#define protected public
#include <functional>
#include <string>
#include <vector>

#include "only_wrong.hpp"
#undef private
#undef protected
