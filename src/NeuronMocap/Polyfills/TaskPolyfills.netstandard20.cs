namespace System.Threading.Tasks;

internal static class TaskPolyfills
{
    extension(Task task)
    {
        public bool IsCompletedSuccessfully => task.Status == TaskStatus.RanToCompletion;
    }
}
