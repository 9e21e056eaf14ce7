#nullable enable

using System;
using UnityEngine;
using UnityEngine.Events;

namespace NeuronMocap.Unity
{
    // Calls the handlers of rare events. If a handler throws, the exception goes to the console, like that of a script's own method. The caller and
    // the other handlers continue.
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

        // The handlers that are set in the inspector. Unity calls none after one that throws.
        public static void Raise<T>(UnityEvent<T> handlers, T value, UnityEngine.Object context)
        {
            try
            {
                handlers.Invoke(value);
            }
            catch (Exception exception)
            {
                Debug.LogException(exception, context);
            }
        }
    }
}
