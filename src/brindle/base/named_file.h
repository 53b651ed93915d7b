#pragma once
#include "brindle/base/file_names.h"
