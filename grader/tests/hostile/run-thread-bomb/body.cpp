for (;;) std::thread([] { for (;;) std::this_thread::yield(); }).detach();
