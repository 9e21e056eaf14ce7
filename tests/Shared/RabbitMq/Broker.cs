using System.Diagnostics;
using System.Globalization;
using NeuronMocap.Tests.Network;
using RabbitMQ.Client;
using RabbitMQ.Client.Exceptions;

namespace NeuronMocap.Tests.RabbitMq;

/// <summary>
/// A RabbitMQ broker as a process of its own, with its files in a temporary folder, its own ports and its own name service. It ends with this process.
/// </summary>
internal sealed class Broker : IAsyncDisposable
{
    // The program in /usr/sbin asks for root or the user rabbitmq.
    private const string Server = "/usr/lib/rabbitmq/bin/rabbitmq-server";

    // A user whom the broker knows, without any permission.
    public const string Stranger = "stranger";

    // A user with all permissions, and a password that is easy to find in outputs.
    public const string Actor = "actor";
    public const string ActorPassword = "s3cret-word";

    // It takes 3 s of processor time to start.
    private static readonly TimeSpan StartLimit = TimeSpan.FromMinutes(3);

    private readonly string _folder = Directory.CreateTempSubdirectory("broker-").FullName;
    private readonly int _namePort = FreePort.Next();
    private readonly int _nodePort = FreePort.Next();
    private Process? _names;
    private Process? _server;

    private Broker() => Port = FreePort.Next();

    public int Port { get; }

    public string Address => string.Create(CultureInfo.InvariantCulture, $"amqp://guest:guest@127.0.0.1:{Port}/");

    /// <summary>Why there can be no broker here; null if there can.</summary>
    public static string? Missing => File.Exists(Server) ? null : $"There is no {Server}; Debian's package rabbitmq-server has it.";

    public static async Task<Broker> StartAsync()
    {
        var broker = new Broker();
        try
        {
            broker.WriteFiles();
            broker._names = broker.Run(string.Create(CultureInfo.InvariantCulture, $"epmd -port {broker._namePort}"), "names.log");
            await broker.RestartAsync();
            return broker;
        }
        catch
        {
            await broker.DisposeAsync();
            throw;
        }
    }

    /// <summary>Ends the broker at once, as a power failure does.</summary>
    public void Kill() => End(ref _server);

    /// <summary>Starts the broker again, with the files that it has.</summary>
    public async Task RestartAsync()
    {
        _server = Run(Server, "server.log");
        using var limit = new CancellationTokenSource(StartLimit);
        var factory = new ConnectionFactory { HostName = "127.0.0.1", Port = Port, AutomaticRecoveryEnabled = false };
        while (true)
        {
            try
            {
                await using IConnection connection = await factory.CreateConnectionAsync(limit.Token);
                await using IChannel channel = await connection.CreateChannelAsync(cancellationToken: limit.Token);
                return;
            }
            catch (Exception exception) when (exception is BrokerUnreachableException or OperationInterruptedException or IOException)
            {
                if (_server.HasExited || limit.IsCancellationRequested)
                    throw new InvalidOperationException($"The broker did not start: {await File.ReadAllTextAsync(PathOf("server.log"))}", exception);

                await Task.Delay(100, CancellationToken.None);
            }
        }
    }

    /// <summary>
    /// Whether the broker finds its streams after it was killed. RabbitMQ 3.10 writes the name of what manages them half a second after the first stream
    /// was declared, and never finds them if it is killed before.
    /// </summary>
    public bool KeepsStreams => Directory.GetFiles(_folder, "names.dets", SearchOption.AllDirectories)
        .Any(static file => File.ReadAllBytes(file).AsSpan().IndexOf("rabbit_stream_coordinator"u8) >= 0);

    public ValueTask DisposeAsync()
    {
        Kill();
        End(ref _names);
        try
        {
            Directory.Delete(_folder, recursive: true);
        }
        catch (IOException)
        {
            // A process that was killed may hold a file for a moment. The folder is temporary.
        }

        return ValueTask.CompletedTask;
    }

    private string PathOf(string name) => Path.Combine(_folder, name);

    private void WriteFiles()
    {
        File.WriteAllText(PathOf("plugins"), "[].");
        File.WriteAllText(PathOf("definitions.json"), $$"""
            {
              "users": [
                { "name": "guest", "password": "guest", "tags": "administrator" },
                { "name": "{{Actor}}", "password": "{{ActorPassword}}", "tags": "" },
                { "name": "{{Stranger}}", "password": "guest", "tags": "" }
              ],
              "vhosts": [ { "name": "/" } ],
              "permissions": [
                { "user": "guest", "vhost": "/", "configure": ".*", "write": ".*", "read": ".*" },
                { "user": "{{Actor}}", "vhost": "/", "configure": ".*", "write": ".*", "read": ".*" }
              ]
            }
            """);
        File.WriteAllText(PathOf("rabbitmq.conf"), string.Create(CultureInfo.InvariantCulture, $"""
            listeners.tcp.default = 127.0.0.1:{Port}
            load_definitions = {PathOf("definitions.json")}
            disk_free_limit.absolute = 10MB
            log.file.level = warning

            """));
    }

    // A shell ends the program when the pipe to this process closes, also if a debugger or a time limit kills the tests.
    private Process Run(string program, string log)
    {
        var start = new ProcessStartInfo("/bin/sh")
        {
            ArgumentList = { "-c", $"exec 2> /dev/null; {program} > '{PathOf(log)}' 2>&1 & program=$!; cat > /dev/null; kill -9 $program; wait $program" },
            UseShellExecute = false,
            RedirectStandardInput = true,
            Environment =
            {
                ["HOME"] = _folder,
                ["ERL_EPMD_PORT"] = _namePort.ToString(CultureInfo.InvariantCulture),
                ["RABBITMQ_NODENAME"] = "test@localhost",
                ["RABBITMQ_MNESIA_BASE"] = PathOf("data"),
                ["RABBITMQ_LOG_BASE"] = PathOf("log"),
                ["RABBITMQ_DIST_PORT"] = _nodePort.ToString(CultureInfo.InvariantCulture),
                ["RABBITMQ_ENABLED_PLUGINS_FILE"] = PathOf("plugins"),
                ["RABBITMQ_CONFIG_FILE"] = PathOf("rabbitmq.conf"),
                ["RABBITMQ_CONF_ENV_FILE"] = "/dev/null",
                // The script then becomes the broker's own process. Idle schedulers of Erlang do not spin.
                ["RABBITMQ_ALLOW_INPUT"] = "1",
                ["RABBITMQ_SERVER_ADDITIONAL_ERL_ARGS"] = "-noinput -start_epmd false +sbwt none +sbwtdcpu none +sbwtdio none",
            },
        };
        return Process.Start(start)!;
    }

    private static void End(ref Process? process)
    {
        if (process is null)
            return;

        process.StandardInput.Close();
        process.WaitForExit();
        process.Dispose();
        process = null;
    }
}
