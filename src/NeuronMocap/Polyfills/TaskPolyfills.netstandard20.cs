namespace NeuronMocap.Polyfills;

internal static class TaskPolyfills
{
    extension(Task task)
    {
        public bool IsCompletedSuccessfully => task.Status == TaskStatus.RanToCompletion;
    }
}
