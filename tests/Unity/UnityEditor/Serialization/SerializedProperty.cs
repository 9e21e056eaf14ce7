using System.Collections;
using System.Globalization;
using System.Reflection;
using UnityEngine;

namespace UnityEditor;

public sealed partial class SerializedProperty
{
    // An iterator moves from one of these to the next. Before the first, it refers to none.
    private readonly IReadOnlyList<SerializedProperty>? _all;
    private int _at = -1;
    private FieldInfo _field;
    private object? _value;

    internal SerializedProperty(SerializedObject owner, FieldInfo field)
    {
        serializedObject = owner;
        _field = field;
        Read();
    }

    internal SerializedProperty(SerializedObject owner, IReadOnlyList<SerializedProperty> all)
    {
        serializedObject = owner;
        _all = all;
        _field = null!;
    }

    public SerializedObject serializedObject { get; }

    public string name => _field.Name;

    public string propertyPath => _field.Name;

    public string displayName => SerializedFields.Nicify(_field.Name);

    public string tooltip => _field.GetCustomAttribute<TooltipAttribute>()?.tooltip ?? "";

    public SerializedPropertyType propertyType =>
        HeldType == typeof(bool) ? SerializedPropertyType.Boolean
        : HeldType == typeof(float) ? SerializedPropertyType.Float
        : HeldType == typeof(string) ? SerializedPropertyType.String
        : HeldType.IsEnum ? SerializedPropertyType.Enum
        : HeldType.IsPrimitive ? SerializedPropertyType.Integer
        : typeof(UnityEngine.Object).IsAssignableFrom(HeldType) ? SerializedPropertyType.ObjectReference
        : SerializedPropertyType.Generic;

    public bool editable => serializedObject.targetObjects.All(static target => !target.hideFlags.HasFlag(HideFlags.NotEditable));

    public bool isExpanded { get; set; }

    public bool hasMultipleDifferentValues { get; private set; }

    public bool isArray => typeof(IList).IsAssignableFrom(HeldType);

    public bool boolValue
    {
        get => (bool)_value!;
        set => Set(value);
    }

    public int intValue
    {
        get => Convert.ToInt32(_value, CultureInfo.InvariantCulture);
        set => Set(value);
    }

    public float floatValue
    {
        get => Convert.ToSingle(_value, CultureInfo.InvariantCulture);
        set => Set(value);
    }

    public string stringValue
    {
        get => (string?)_value ?? "";
        set => Set(value);
    }

    public int enumValueIndex
    {
        get => Array.IndexOf(Enum.GetValues(HeldType), _value);
        set => Set(Enum.GetValues(HeldType).GetValue(value));
    }

    public UnityEngine.Object? objectReferenceValue
    {
        get => _value as UnityEngine.Object;
        set => Set(value);
    }

    internal bool IsModified { get; private set; }

    internal string ShownValue => hasMultipleDifferentValues ? "\u2014" : _value switch
    {
        null => $"None ({_field.FieldType.Name})",
        UnityEngine.Object item => item == null ? $"None ({_field.FieldType.Name})" : item.name,
        bool flag => flag ? "on" : "off",
        Enum choice => SerializedFields.Nicify(choice.ToString()),
        string text => text,
        IList list => $"{list.Count} elements",
        IFormattable number => number.ToString(null, CultureInfo.InvariantCulture),
        ValueType other => other.ToString() ?? "",

        // A foldout.
        _ => "",
    };

    public bool NextVisible(bool enterChildren)
    {
        if (_all is null || ++_at >= _all.Count)
            return false;

        (_field, _value, hasMultipleDifferentValues) = (_all[_at]._field, _all[_at]._value, _all[_at].hasMultipleDifferentValues);
        return true;
    }

    internal void Read()
    {
        _value = _field.GetValue(serializedObject.targetObject);
        hasMultipleDifferentValues = serializedObject.targetObjects.Any(target => !Equals(_field.GetValue(target), _value));
        IsModified = false;
    }

    internal void Write()
    {
        if (!IsModified)
            return;

        foreach (UnityEngine.Object target in serializedObject.targetObjects)
            _field.SetValue(target, isArray ? Copy(_value, HeldType) : _value);

        (IsModified, hasMultipleDifferentValues) = (false, false);
    }

    /// <summary>Sets a value as if typed: ranges and lower bounds apply, as in the inspector. A number typed for a list is its size.</summary>
    internal void SetShown(object? value)
    {
        if (isArray && value is int size)
        {
            arraySize = size;
            return;
        }

        if (value is IConvertible number and not string and not Enum && _field.GetCustomAttribute<RangeAttribute>() is { } range)
            value = Mathf.Clamp(number.ToSingle(CultureInfo.InvariantCulture), range.min, range.max);
        if (value is IConvertible other and not string and not Enum && _field.GetCustomAttribute<MinAttribute>() is { } least)
            value = Mathf.Max(other.ToSingle(CultureInfo.InvariantCulture), least.min);

        Set(value);
    }

    private void Set(object? value)
    {
        if (_all is not null)
        {
            _all[_at].Set(value);
            return;
        }

        object? converted = value is null || HeldType.IsInstanceOfType(value) ? value
            : HeldType.IsEnum ? Enum.ToObject(HeldType, value)
            : Convert.ChangeType(value, HeldType, CultureInfo.InvariantCulture);
        if (Equals(converted, _value) && !hasMultipleDifferentValues)
            return;

        _value = converted;
        IsModified = true;
        _whole?.Replace(this);
    }
}
