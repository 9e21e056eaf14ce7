namespace NeuronMocap.Commands;

// The answer to one question, shared by all callers. Any thread.
internal sealed class SharedAnswer<T>(Func<Task<T>> ask)
{
    private readonly object _lock = new();
    private Task<T>? _answer;

    // Asks the server if no caller has asked yet, or if the server gave no answer; on a retry, also after an invalid or negative answer.
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
