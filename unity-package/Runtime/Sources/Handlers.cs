#nullable enable

using System;
using UnityEngine;

namespace NeuronMocap.Unity
{
    // Calls the handlers of rare events. One that throws is told in the console, as a script's own method that throws is; it holds up neither what
    // raised the event nor the other handlers.
    internal static class Handlers
    {
        public static void Raise<T>(Action<T>? handlers, T value, UnityEngine.Object context)
        {
            if (handlers is null)
                return;

            foreach (Delegate handler in handlers.GetInvocationList())
            {
                try
                {
                    ((Action<T>)handler)(value);
                }
                catch (Exception exception)
                {
                    Debug.LogException(exception, context);
                }
            }
        }
    }
}
