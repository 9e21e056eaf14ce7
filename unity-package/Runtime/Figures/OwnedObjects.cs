#nullable enable
using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace NeuronMocap.Unity
{
    // On an object that was built: destroys what Unity does not collect (avatars, meshes, materials, textures) with it, however it ends.
    [ExecuteAlways]
    [AddComponentMenu("")]
    internal sealed class OwnedObjects : MonoBehaviour
    {
        // Not readonly: when the editor compiles scripts in play mode it carries private lists of Unity's objects over, but no readonly ones. A copy
        // of the object that Instantiate makes gets none, and owns none.
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
