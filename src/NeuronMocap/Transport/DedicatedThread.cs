namespace NeuronMocap.Transport;

internal static class DedicatedThread
{
    // Runs a blocking action on its own background thread, which never keeps the process alive. The task ends like the action. Code that awaits the task
    // continues on a pool thread or, with no options, on this thread; it then needs no other thread.
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
                // The task may already be completed: Mono aborts threads at the end of a process and when Unity's editor reloads scripts, even in code
                // that continues here.
                completion.TrySetException(exception);
            }
        }
    }
}
