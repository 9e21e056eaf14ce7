using System.Globalization;

namespace UnityEditor;

/// <summary>The permanent name of an object: its file, its number there and, in an instance of a prefab, the number of the instance.</summary>
public struct GlobalObjectId
{
    private const int ImportedAsset = 1;
    private const int SceneObject = 2;

    private string _guid;

    public int identifierType { get; private set; }

    public ulong targetObjectId { get; private set; }

    public ulong targetPrefabId { get; private set; }

    public static bool TryParse(string stringValue, out GlobalObjectId id)
    {
        id = default;
        string[] parts = stringValue.Split('-');
        if (parts.Length != 5 || parts[0] != "GlobalObjectId_V1" || parts[2].Length != 32)
            return false;

        if (!int.TryParse(parts[1], NumberStyles.None, CultureInfo.InvariantCulture, out int type)
            || !ulong.TryParse(parts[3], NumberStyles.None, CultureInfo.InvariantCulture, out ulong local)
            || !ulong.TryParse(parts[4], NumberStyles.None, CultureInfo.InvariantCulture, out ulong prefab))
        {
            return false;
        }

        id = new GlobalObjectId { identifierType = type, _guid = parts[2], targetObjectId = local, targetPrefabId = prefab };
        return true;
    }

    /// <returns>Null if the object is not loaded.</returns>
    public static UnityEngine.Object? GlobalObjectIdentifierToObjectSlow(GlobalObjectId id) => id.identifierType is ImportedAsset or SceneObject
        ? FileIds.Find(id._guid, unchecked((long)id.targetObjectId), unchecked((long)id.targetPrefabId))
        : null;
}
