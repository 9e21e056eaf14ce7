using System.Reflection;
using System.Text;

namespace UnityEditor;

internal static class SerializedFields
{
    private const BindingFlags Declared = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

    public static FieldInfo? Find(Type type, string name) => Of(type).FirstOrDefault(field => field.Name == name);

    public static IEnumerable<FieldInfo> Of(Type type) => UnityEngine.StandIn.Serialization.GetFields(type);

    public static void CallOnValidate(UnityEngine.Object target)
    {
        for (Type? at = target.GetType(); at is not null; at = at.BaseType)
        {
            if (at.GetMethod("OnValidate", Declared, null, Type.EmptyTypes, null) is not { } method)
                continue;

            method.Invoke(target, null);
            return;
        }
    }

    /// <summary>Converts a field's name as the inspector does: "_commandPort" becomes "Command Port".</summary>
    public static string Nicify(string name)
    {
        string bare = name.StartsWith("m_", StringComparison.Ordinal) ? name[2..] : name.TrimStart('_');
        var words = new StringBuilder();
        for (int i = 0; i < bare.Length; i++)
        {
            bool isNewWord = i > 0 && char.IsUpper(bare[i]) && (!char.IsUpper(bare[i - 1]) || (i + 1 < bare.Length && char.IsLower(bare[i + 1])));
            if (isNewWord)
                words.Append(' ');

            words.Append(i == 0 ? char.ToUpperInvariant(bare[i]) : bare[i]);
        }

        return words.ToString();
    }
}
