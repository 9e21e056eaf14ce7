// The callbacks under test are one set for the whole process.
[assembly: CollectionBehavior(DisableTestParallelization = true)]
