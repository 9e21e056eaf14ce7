namespace UnityEditor;

public struct EditorCurveBinding
{
    public string path;
    public string propertyName;

    public Type type { get; set; }

    public static EditorCurveBinding FloatCurve(string inPath, Type inType, string inPropertyName) =>
        new() { path = inPath, type = inType, propertyName = inPropertyName };
}
