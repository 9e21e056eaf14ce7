#nullable enable

using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading.Tasks;
using UnityEngine;

namespace NeuronMocap.Unity
{
    // The connections of all sources, one for each set of settings. Main thread only.
    internal static partial class SourceConnections
    {
        // How long the end of a program, or of its domain, waits for threads that were asked to stop.
        private static readonly TimeSpan CloseTimeout = TimeSpan.FromMilliseconds(100);

        private static readonly Dictionary<SourceSettings, SourceConnection> Open = new Dictionary<SourceSettings, SourceConnection>();
        private static readonly List<(SourceSettings Settings, Task End)> Closing = new List<(SourceSettings Settings, Task End)>();

        // The number of open connections.
        public static int Count => Open.Count;

        // Ends when all closed connections have ended, including their threads.
        public static Task Closed
        {
            get
            {
                ForgetClosed();
                return Task.WhenAll(Closing.Select(closing => closing.End));
            }
        }

        public static SourceConnection Acquire(SourceSettings settings)
        {
            if (!Open.TryGetValue(settings, out SourceConnection? connection))
            {
                connection = new SourceConnection(settings, settings.IsUdp ? FreeUdpPorts() : Task.CompletedTask);
                Open.Add(settings, connection);
            }

            connection.UserCount++;
            return connection;
        }

        public static void Release(SourceConnection connection)
        {
            if (--connection.UserCount > 0)
                return;

            // At the end of the program, all are already closed.
            if (Open.TryGetValue(connection.Settings, out SourceConnection? open) && open == connection)
                Open.Remove(connection.Settings);

            ForgetClosed();
            Close(connection);
        }

        private static void Close(SourceConnection connection) => Closing.Add((connection.Settings, connection.Close()));

        private static void ForgetClosed() => Closing.RemoveAll(closing => closing.End.IsCompleted);

        // Only one socket can hold a UDP port. Files may take longer to close, and are not waited for.
        private static Task FreeUdpPorts()
        {
            ForgetClosed();
            return Task.WhenAll(Closing.Where(closing => closing.Settings.IsUdp).Select(closing => closing.End));
        }

        // Without a domain reload, statics keep their values when play mode is entered again.
        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Reset()
        {
            CloseAll();
            MocapSource.ForgetAll();
            Application.quitting -= CloseAll;
            Application.quitting += CloseAll;
        }

        private static void CloseAll()
        {
            foreach (SourceConnection connection in Open.Values)
                Close(connection);

            Open.Clear();
            try
            {
                _ = Closed.Wait(CloseTimeout);
            }
            catch (AggregateException)
            {
                // The connection is closed, even if closing failed.
            }
        }
    }
}
