#include "x11/display.h"
