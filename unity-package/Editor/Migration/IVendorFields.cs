#nullable enable

using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // The serialised fields of a vendor's component. Null: there is no such field, because versions differ.
    internal interface IVendorFields
    {
        string? FindText(string name);

        // A number, the number of an enum value, or 0 and 1 for a switch.
        float? FindNumber(string name);

        T? FindObject<T>(string name)
            where T : Object;
    }
}
