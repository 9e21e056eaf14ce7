namespace UnityEditor;

/// <param name="file">The GUID of the file.</param>
/// <param name="local">The number in the file; in an instance, that of the prefab's object.</param>
/// <param name="instance">The number of the prefab instance, or 0.</param>
/// <param name="stub">In an instance, the number of the entry that stands for the object, or 0.</param>
/// <param name="source">The object of the prefab.</param>
internal sealed class FileId(string file, long local, long instance = 0, long stub = 0, UnityEngine.Object? source = null)
{
    public string File => file;

    public long Local => local;

    public long Instance => instance;

    public long Stub => stub;

    public UnityEngine.Object? Source => source;
}
