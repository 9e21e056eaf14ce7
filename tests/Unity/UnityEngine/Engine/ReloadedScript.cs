using System.Reflection;

namespace UnityEngine.StandIn;

/// <summary>
/// What becomes of a script's fields when scripts are compiled anew while the game runs: those of kinds that Unity can keep are carried over, private
/// ones included; the others are as in a new object.
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
