using System.Globalization;
using System.Reflection;
using System.Runtime.CompilerServices;
using System.Text;
using UnityEngine;
using UnityEngine.StandIn;
using Object = UnityEngine.Object;

namespace UnityEditor;

// Writes what it reads.
internal sealed partial class ObjectFile
{
    private static readonly System.Random Numbers = new();

    // The entries of prefab instances, by their root. They are written as they were read.
    private static readonly ConditionalWeakTable<GameObject, string> InstanceTexts = new();

    public static void Save(string path, IEnumerable<GameObject> roots)
    {
        string guid = AssetDatabase.AssetPathToGUID(path);
        var text = new StringBuilder("%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n");
        GameObject[] all = [.. roots.SelectMany(static root => root.GetComponentsInChildren<Transform>(true)).Select(static part => part.gameObject)];

        // Numbers first, because objects refer to each other.
        foreach (Object item in all.SelectMany(static item => (IEnumerable<Object>)[item, .. item.Components]))
        {
            if (FileIds.Of(item) is null)
                FileIds.Set(item, new FileId(guid, Numbers.Next(1_000_000, int.MaxValue)));
        }

        foreach (GameObject item in all)
            Write(item, text);

        File.WriteAllText(AssetDatabase.ToFile(path), text.ToString());
    }

    private static void Write(GameObject item, StringBuilder text)
    {
        if (InstanceTexts.TryGetValue(item, out string? instance))
            text.Append(instance).Append('\n');

        WriteHeader(item, 1, "GameObject", text);
        if (FileIds.Of(item) is { Source: null })
            text.Append("  m_Name: ").Append(item.name).Append("\n  m_IsActive: ").Append(item.activeSelf ? 1 : 0).Append('\n');

        foreach (Component component in item.Components)
            Write(component, text);
        foreach (string missing in item.MissingScripts)
            text.Append(missing).Append('\n');
    }

    private static void Write(Component component, StringBuilder text)
    {
        (int classId, string name) = component switch
        {
            Transform => (4, "Transform"),
            Animator => (95, "Animator"),
            MonoBehaviour => (114, "MonoBehaviour"),
            _ => throw new NotSupportedException($"A component {component.GetType().Name}."),
        };
        WriteHeader(component, classId, name, text);
        if (FileIds.Of(component) is not { Source: null })
            return;

        text.Append("  m_GameObject: ").Append(Reference(component.gameObject)).Append('\n');
        if (component is Transform transform)
            text.Append("  m_Father: ").Append(Reference(transform.parent)).Append('\n');
        else if (component is MonoBehaviour script)
            WriteFields(script, text);
    }

    private static void WriteFields(MonoBehaviour script, StringBuilder text)
    {
        text.Append("  m_Enabled: ").Append(script.enabled ? 1 : 0).Append('\n');
        text.Append("  m_Script: {fileID: 11500000, guid: ").Append(AssetDatabase.GetScriptGuid(script.GetType())).Append(", type: 3}\n");
        foreach (FieldInfo field in Serialization.GetFields(script.GetType()))
        {
            string? value = field.GetValue(script) switch
            {
                Object item => Reference(item),
                bool flag => flag ? "1" : "0",
                Enum choice => Convert.ToInt32(choice, CultureInfo.InvariantCulture).ToString(CultureInfo.InvariantCulture),
                string words => words,
                IFormattable number when field.FieldType.IsPrimitive => number.ToString(null, CultureInfo.InvariantCulture),
                _ => null,
            };
            if (value is not null)
                text.Append("  ").Append(field.Name).Append(": ").Append(value).Append('\n');
        }
    }

    // An object of an instance only has a stub, and only if something refers to it.
    private static void WriteHeader(Object item, int classId, string name, StringBuilder text)
    {
        FileId id = FileIds.Of(item)!;
        if (id.Source is null)
        {
            text.Append(FormattableString.Invariant($"--- !u!{classId} &{id.Local}\n{name}:\n"));
        }
        else if (id.Stub != 0)
        {
            text.Append(FormattableString.Invariant($"--- !u!{classId} &{id.Stub} stripped\n{name}:\n"));
            text.Append(FormattableString.Invariant($"  m_CorrespondingSourceObject: {{fileID: {id.Local}, guid: {FileIds.Of(id.Source)!.File}, type: 3}}\n"));
            text.Append(FormattableString.Invariant($"  m_PrefabInstance: {{fileID: {id.Instance}}}\n"));
        }
    }

    private static string Reference(Object? item)
    {
        FileId? id = item is null || item.IsDestroyed ? null : FileIds.Of(item);
        return FormattableString.Invariant($"{{fileID: {(id is null ? 0 : id.Source is null ? id.Local : id.Stub)}}}");
    }
}
