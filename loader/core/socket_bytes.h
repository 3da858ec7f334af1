// Bytes through a stream socket between two processes of one command, all or none.
#pragma once

#include <cstddef>

namespace orris {

/// false: the other end is gone.
bool sendAll(int socket, const void* data, std::size_t size);
bool receiveAll(int socket, void* data, std::size_t size);

}  // namespace orris
