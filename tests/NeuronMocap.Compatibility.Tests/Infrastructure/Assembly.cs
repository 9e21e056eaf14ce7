// The process has only one set of the callbacks under test.
[assembly: CollectionBehavior(DisableTestParallelization = true)]
