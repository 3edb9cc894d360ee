    // Nobody builds a cycle.
