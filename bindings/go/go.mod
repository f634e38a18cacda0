// SPDX-License-Identifier: Apache-2.0
module abut

go 1.19
