#nullable enable
using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace NeuronMocap.Unity
{
    // Destroys objects that Unity does not collect (avatars, meshes, materials, textures) together with the object that was built for them.
    [ExecuteAlways]
    [AddComponentMenu("")]
    internal sealed class OwnedObjects : MonoBehaviour
    {
        // Not readonly: when the editor compiles scripts in play mode, it keeps private lists of Unity's objects, but not readonly ones. A copy made
        // by Instantiate has an empty list and owns nothing.
        private List<Object> _objects = new List<Object>();

        public T Keep<T>(T thing)
            where T : Object
        {
            _objects.Add(thing);
            return thing;
        }

        private void OnDestroy()
        {
            foreach (Object thing in _objects)
                Disposal.Destroy(thing);

            _objects.Clear();
        }
    }
}
