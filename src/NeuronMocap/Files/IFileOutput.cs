namespace NeuronMocap.Files;

// A file output writes what a reader receives. Log messages use these members. They can be called on any thread.
internal interface IFileOutput
{
    // The path as the caller gave it.
    string Path { get; }

    Task Completion { get; }

    Exception? Failure { get; }

    // Number of pieces or frames that were received but not written to a file.
    long Lost { get; }

    // Number of old files that could not be deleted.
    int UndeletedFiles { get; }

    // Complete sentences for the log.
    string DescribeStart();

    string DescribeLoss(long count);

    string DescribeUndeleted();

    string DescribeEnd();

    // Called when the reader has ended. Does not wait.
    void Stop();

    // Like Completion, but continuations run on the output's thread.
    Task Ended { get; }
}
