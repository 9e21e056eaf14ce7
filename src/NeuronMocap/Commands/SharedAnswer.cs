namespace NeuronMocap.Commands;

// The answer to one question, shared by everyone who asks it. Any thread.
internal sealed class SharedAnswer<T>(Func<Task<T>> ask)
{
    private readonly object _lock = new();
    private Task<T>? _answer;

    // Asks the server where nobody has, or where it gave no answer yet; on a retry, also where it gave another answer than expected.
    public Task<T> GetAsync(bool isRetry)
    {
        lock (_lock)
        {
            if (_answer is null || (_answer.IsFaulted && (isRetry || IsUnanswered(_answer))))
                _answer = ask();

            return _answer;
        }
    }

    private static bool IsUnanswered(Task task) =>
        task.Exception!.InnerException is not NeuronCommandException exception || !exception.IsAnswer;
}
