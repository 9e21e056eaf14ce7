namespace NeuronMocap.Files;

// What writes to files what a reader receives, as logs tell of it. Any thread.
internal interface IFileOutput
{
    // As it was asked for.
    string Path { get; }

    Task Completion { get; }

    Exception? Failure { get; }

    // Pieces or frames that arrived and are in no file.
    long Lost { get; }

    // Old files that should be gone.
    int UndeletedFiles { get; }

    // Sentences.
    string DescribeStart();

    string DescribeLoss(long count);

    string DescribeUndeleted();

    string DescribeEnd();

    // The reader has ended. Without waiting.
    void Stop();

    // As Completion, but what awaits it goes on on the output's thread.
    Task Ended { get; }
}
