using System.Collections;
using System.Reflection;

namespace UnityEditor;

// Elements of lists, and fields of values. A change of a part is a change of the whole.
public sealed partial class SerializedProperty
{
    private readonly SerializedProperty? _whole;
    private readonly int _index = -1;

    private SerializedProperty(SerializedProperty whole, FieldInfo field, int index, object? value)
    {
        serializedObject = whole.serializedObject;
        (_whole, _field, _index, _value) = (whole, field, index, value);
    }

    /// <summary>Elements that are added are copies of the last one. Those of an empty list have the default of their type: all zeros.</summary>
    public int arraySize
    {
        get => (_value as IList)?.Count ?? 0;

        set
        {
            var list = (IList)Copy(_value, HeldType)!;
            while (list.Count > value)
                list.RemoveAt(list.Count - 1);
            while (list.Count < value)
                list.Add(list.Count > 0 ? Copy(list[^1], ElementType) : ElementType.IsValueType ? Activator.CreateInstance(ElementType) : null);

            Set(list);
        }
    }

    private Type HeldType => _index < 0 ? _field.FieldType : _whole!.ElementType;

    private Type ElementType => UnityEngine.StandIn.Serialization.GetElementType(HeldType)!;

    public SerializedProperty GetArrayElementAtIndex(int index) => new(this, _field, index, ((IList)_value!)[index]);

    public SerializedProperty FindPropertyRelative(string relativePropertyPath)
    {
        // Null if the field does not exist, as in Unity, although the signature does not say so.
        FieldInfo? field = SerializedFields.Find(HeldType, relativePropertyPath);
        return field is null ? null! : new SerializedProperty(this, field, -1, field.GetValue(_value));
    }

    private void Replace(SerializedProperty part)
    {
        object copy = Copy(_value, HeldType)!;
        if (part._index < 0)
            part._field.SetValue(copy, part._value);
        else
            ((IList)copy)[part._index] = part._value;

        Set(copy);
    }

    private static object? Copy(object? value, Type type) => UnityEngine.StandIn.Serialization.Copy(value, type, static item => item);
}
