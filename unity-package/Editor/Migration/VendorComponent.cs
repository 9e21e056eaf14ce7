#nullable enable

using System;
using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // A vendor's component on an object.
    internal sealed class VendorComponent
    {
        private VendorComponent(VendorScript script, GameObject? owner, MonoBehaviour? component, IVendorFields fields, bool isEnabled)
        {
            Script = script;
            Owner = owner;
            Component = component;
            Fields = fields;
            IsEnabled = isEnabled;
        }

        public VendorScript Script { get; }

        // Null if the file has changed since it was loaded.
        public GameObject? Owner { get; }

        // Null if its script is missing.
        public MonoBehaviour? Component { get; }

        public IVendorFields Fields { get; }

        public bool IsEnabled { get; }

        // Components that come with a prefab are found in the file of the prefab.
        public static List<VendorComponent> FindAll(MigrationFile file, IReadOnlyDictionary<string, VendorScript> guids)
        {
            var found = new List<VendorComponent>();
            foreach (MonoBehaviour component in file.FindComponents<MonoBehaviour>())
            {
                if (VendorScripts.Of(component.GetType()) is { } script && PrefabUtility.GetCorrespondingObjectFromSource(component) == null)
                    found.Add(new VendorComponent(script, component.gameObject, component, new PresentFields(component), component.enabled));
            }

            if (file.Text == null)
                return found;

            foreach (YamlDocument document in file.Text.Scripts)
            {
                if (!guids.TryGetValue(document.FindGuid("m_Script"), out VendorScript? script) || !script.IsMissing)
                    continue;

                // An open scene may have changed since it was saved.
                var owner = file.FindObject(document.FindReference("m_GameObject")) as GameObject;
                if (owner == null || GameObjectUtility.GetMonoBehavioursWithMissingScriptCount(owner) > 0)
                    found.Add(new VendorComponent(script, owner, null, new MissingFields(file, document), !(document.Find("m_Enabled") is "0")));
            }

            return found;
        }

        // Why it cannot be removed. Empty if it can.
        public string FindObstacle()
        {
            if (Owner == null)
                return "Its object is not in the loaded scene. Save the scene and search again.";
            if (Component == null)
            {
                return GameObjectUtility.GetMonoBehavioursWithMissingScriptCount(Owner) == 1
                    ? string.Empty
                    : "The object has other missing scripts, and Unity can only remove all of them together. Restore or remove the others first.";
            }

            foreach (Component other in Owner.GetComponents<Component>())
            {
                if (other != null && other != Component && Requires(other.GetType(), Component.GetType()))
                    return $"{other.GetType().Name} on the same object requires it.";
            }

            return string.Empty;
        }

        public void Remove()
        {
            if (Component != null)
            {
                Undo.DestroyObjectImmediate(Component);
                return;
            }

            Undo.RegisterCompleteObjectUndo(Owner!, "Remove Missing Scripts");
            GameObjectUtility.RemoveMonoBehavioursWithMissingScript(Owner!);
        }

        private static bool Requires(Type type, Type needed) => type.GetCustomAttributes(typeof(RequireComponent), true).Cast<RequireComponent>()
            .Any(require => Is(require.m_Type0, needed) || Is(require.m_Type1, needed) || Is(require.m_Type2, needed));

        private static bool Is(Type? required, Type type) => required != null && required.IsAssignableFrom(type);
    }
}
