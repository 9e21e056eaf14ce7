namespace NeuronMocap.Transport;

internal static class DedicatedThread
{
    // Runs what blocks on a background thread of its own, which never keeps the process alive; the task ends as it does. What awaits the task
    // goes on on a pool thread, or, with no options, on this thread, for which nothing has to be free.
    public static Task RunAsync(string name, Action action, TaskCreationOptions options = TaskCreationOptions.RunContinuationsAsynchronously)
    {
        var completion = new TaskCompletionSource<bool>(options);
        new Thread(Run) { IsBackground = true, Name = name }.Start();
        return completion.Task;

        void Run()
        {
            try
            {
                action();
                completion.SetResult(true);
            }
            catch (Exception exception)
            {
                // Not when it is completed already: Mono aborts threads when a process ends or Unity's editor reloads scripts, in the midst of what goes on here too.
                completion.TrySetException(exception);
            }
        }
    }
}
