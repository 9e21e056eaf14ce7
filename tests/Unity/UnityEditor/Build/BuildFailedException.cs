namespace UnityEditor.Build;

public class BuildFailedException(string message) : Exception(message);
