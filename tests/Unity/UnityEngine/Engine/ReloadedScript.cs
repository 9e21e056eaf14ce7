using System.Reflection;

namespace UnityEngine.StandIn;

/// <summary>
/// What happens to a script's fields when scripts are compiled while the game runs. Fields of kinds that Unity can serialise keep their values,
/// including private ones. The others are as in a new object.
/// </summary>
internal static class ReloadedScript
{
    private const BindingFlags Declared = BindingFlags.DeclaredOnly | BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic;

    public static void Renew(MonoBehaviour script)
    {
        var fresh = (MonoBehaviour)Activator.CreateInstance(script.GetType(), nonPublic: true)!;
        for (Type? type = script.GetType(); type is not null && type.Assembly != typeof(Object).Assembly; type = type.BaseType)
        {
            foreach (FieldInfo field in type.GetFields(Declared))
            {
                if (!IsCarried(field))
                    field.SetValue(script, field.GetValue(fresh));
            }
        }

        World.Remove(fresh);
        fresh.MarkDestroyed();
    }

    private static bool IsCarried(FieldInfo field) =>
        !field.IsInitOnly && !field.IsDefined(typeof(NonSerializedAttribute)) && Serialization.IsKept(field.FieldType);
}
