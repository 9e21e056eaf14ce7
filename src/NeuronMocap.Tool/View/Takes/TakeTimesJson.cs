namespace NeuronMocap.Tool.View.Takes;

/// <summary>The times of a performer's frames as the page gets them.</summary>
/// <param name="Step">Frames from one time to the next.</param>
/// <param name="Times">Milliseconds of every frame whose number is a multiple of the step.</param>
/// <param name="IsComplete">Whether the whole file was read. Until then, contacts of the feet can be missing, and poses of characters can change.</param>
internal sealed record TakeTimesJson(int Step, double[] Times, bool IsComplete)
{
    private const double Microseconds = 1000; // in a millisecond
    private const int StepBlocks = 2;

    public static TakeTimesJson Of(Take take, TakePerformer performer)
    {
        // Times that are read after it are complete as well.
        bool isComplete = take.Completion.IsCompleted;
        long[] times = performer.Times.GetBlockTimes(StepBlocks);
        return new TakeTimesJson(StepBlocks * TakeTimes.BlockSize, Array.ConvertAll(times, static time => time / Microseconds), isComplete);
    }
}
