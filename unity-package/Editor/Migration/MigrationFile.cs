#nullable enable

using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEngine;
using UnityEngine.SceneManagement;
using Object = UnityEngine.Object;

namespace NeuronMocap.Unity.EditorTools
{
    // A loaded scene, or a prefab, in which vendor components are looked for.
    internal sealed class MigrationFile
    {
        private readonly string _path;

        public MigrationFile(Scene scene)
        {
            Scene = scene;
            _path = scene.path;
            Name = _path.Length > 0 ? _path : "The new scene";
            Roots = scene.GetRootGameObjects();
            Text = YamlFile.Read(_path);
        }

        public MigrationFile(string path, GameObject prefab)
        {
            _path = path;
            Name = path;
            Roots = new[] { prefab };
            Text = YamlFile.Read(path);
        }

        public string Name { get; }

        // Null for a prefab.
        public Scene? Scene { get; }

        public IReadOnlyList<GameObject> Roots { get; }

        // Null for a scene that was never saved.
        public YamlFile? Text { get; }

        public IEnumerable<T> FindComponents<T>()
            where T : Component => Roots.SelectMany(root => root.GetComponentsInChildren<T>(true)).Where(component => component != null);

        // id: number of the object in the file. Returns null for 0 and for objects that are no longer loaded.
        public Object? FindObject(long id)
        {
            if (id == 0 || Text?.Find(id) is not { } document)
                return null;

            // In a scene, an object of a prefab instance has the number of the prefab's object and that of the instance.
            (long local, long instance) = Scene != null && document.IsStripped
                ? (document.FindReference("m_CorrespondingSourceObject"), document.FindReference("m_PrefabInstance"))
                : (id, 0);
            string text = $"GlobalObjectId_V1-{(Scene != null ? 2 : 1)}-{AssetDatabase.AssetPathToGUID(_path)}-{unchecked((ulong)local)}-{unchecked((ulong)instance)}";
            return GlobalObjectId.TryParse(text, out GlobalObjectId found) ? GlobalObjectId.GlobalObjectIdentifierToObjectSlow(found) : null;
        }
    }
}
