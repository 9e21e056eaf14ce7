// The engine is one world for the whole process, with one main thread.
[assembly: CollectionBehavior(DisableTestParallelization = true)]
