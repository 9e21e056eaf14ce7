namespace UnityEditor;

public enum SerializedPropertyType
{
    Generic = -1,
    Integer,
    Boolean,
    Float,
    String,
    Color,
    ObjectReference,
    LayerMask,
    Enum,
}
