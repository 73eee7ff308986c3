// See batch.h beside this file.
#pragma once
