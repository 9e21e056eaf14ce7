namespace NeuronMocap.Transport;

internal static class ReceiveThread
{
    // Runs a blocking loop on a background thread, which never keeps the process alive; the task ends as the loop does.
    public static Task RunAsync(string name, Action loop)
    {
        var completion = new TaskCompletionSource<bool>(TaskCreationOptions.RunContinuationsAsynchronously);
        new Thread(Run) { IsBackground = true, Name = name }.Start();
        return completion.Task;

        void Run()
        {
            try
            {
                loop();
                completion.SetResult(true);
            }
            catch (Exception exception)
            {
                completion.SetException(exception);
            }
        }
    }
}
