using System.Globalization;
using System.Net.Sockets;
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
    private const string NameServer = "epmd";

    // A user whom the broker knows, without any permission.
    public const string Stranger = "stranger";

    // A user with all permissions, and a password that is easy to find in outputs.
    public const string Actor = "actor";
    public const string ActorPassword = "s3cret-word";

    // Another program may take a port between the choice and the start.
    private const int Attempts = 3;

    // It takes 3 s to 6 s of processor time to start.
    private static readonly TimeSpan StartLimit = TimeSpan.FromMinutes(3);

    private readonly string _folder = Directory.CreateTempSubdirectory("broker-").FullName;
    private readonly int _namePort = FreePort.Next();
    private readonly int _nodePort = FreePort.Next();
    private ChildProcess? _names;
    private ChildProcess? _server;

    private Broker() => Port = FreePort.Next();

    public int Port { get; }

    public string Address => string.Create(CultureInfo.InvariantCulture, $"amqp://guest:guest@127.0.0.1:{Port}/");

    /// <summary>Why there can be no broker here; null if there can.</summary>
    public static string? Missing => File.Exists(Server) && InstalledPrograms.Have(NameServer)
        ? null
        : $"There is no {Server}, or no {NameServer}; Debian's package rabbitmq-server has both.";

    public static async Task<Broker> StartAsync()
    {
        for (int attempt = 1; ; attempt++)
        {
            var broker = new Broker();
            try
            {
                await broker.StartNamesAsync();
                await broker.RestartAsync();
                return broker;
            }
            catch (InvalidOperationException) when (attempt < Attempts)
            {
                await broker.DisposeAsync();
            }
            catch
            {
                await broker.DisposeAsync();
                throw;
            }
        }
    }

    /// <summary>Ends the broker at once, as a power failure does.</summary>
    public void Kill()
    {
        _server?.Dispose();
        _server = null;
    }

    /// <summary>Starts the broker again, with the files that it has.</summary>
    public async Task RestartAsync()
    {
        _server = Run("server.log", Server);
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
            catch (Exception exception)
                when (exception is BrokerUnreachableException or OperationInterruptedException or IOException or OperationCanceledException or TimeoutException)
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

    /// <summary>Deletes a queue or a stream, also while it is used.</summary>
    public async Task DeleteQueueAsync(string name)
    {
        await using IConnection connection = await new ConnectionFactory { HostName = "127.0.0.1", Port = Port }.CreateConnectionAsync();
        await using IChannel channel = await connection.CreateChannelAsync();
        await channel.QueueDeleteAsync(name);
    }

    public ValueTask DisposeAsync()
    {
        Kill();
        _names?.Dispose();
        _names = null;
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
        Directory.CreateDirectory(PathOf("conf.d"));
        File.WriteAllText(PathOf("plugins"), "[].");
        File.WriteAllText(PathOf("advanced.config"), "[].");
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

    // The broker would start a name service that outlives it if this one did not listen yet.
    private async Task StartNamesAsync()
    {
        WriteFiles();
        _names = Run("names.log", NameServer, "-port", _namePort.ToString(CultureInfo.InvariantCulture));
        using var limit = new CancellationTokenSource(StartLimit);
        while (true)
        {
            try
            {
                using var client = new TcpClient();
                await client.ConnectAsync("127.0.0.1", _namePort, limit.Token);
                return;
            }
            catch (SocketException exception)
            {
                if (_names.HasExited)
                    throw new InvalidOperationException($"The name service did not start: {await File.ReadAllTextAsync(PathOf("names.log"))}", exception);

                await Task.Delay(10, limit.Token);
            }
        }
    }

    // Nothing comes from the files of a broker of this computer.
    private ChildProcess Run(string log, params IEnumerable<string> command) => ChildProcess.Start(
        PathOf(log),
        new Dictionary<string, string>(StringComparer.Ordinal)
        {
            ["HOME"] = _folder,
            ["ERL_EPMD_PORT"] = _namePort.ToString(CultureInfo.InvariantCulture),
            ["RABBITMQ_NODENAME"] = "test@localhost",
            ["RABBITMQ_MNESIA_BASE"] = PathOf("data"),
            ["RABBITMQ_LOG_BASE"] = PathOf("log"),
            ["RABBITMQ_DIST_PORT"] = _nodePort.ToString(CultureInfo.InvariantCulture),
            ["RABBITMQ_ENABLED_PLUGINS_FILE"] = PathOf("plugins"),
            ["RABBITMQ_CONFIG_FILE"] = PathOf("rabbitmq.conf"),
            ["RABBITMQ_CONFIG_FILES"] = PathOf("conf.d"),
            ["RABBITMQ_ADVANCED_CONFIG_FILE"] = PathOf("advanced.config"),
            ["RABBITMQ_CONF_ENV_FILE"] = "/dev/null",
            // The script then becomes the broker's own process. Idle schedulers of Erlang do not spin.
            ["RABBITMQ_ALLOW_INPUT"] = "1",
            ["RABBITMQ_SERVER_ADDITIONAL_ERL_ARGS"] = "-noinput -start_epmd false +sbwt none +sbwtdcpu none +sbwtdio none",
        },
        command);
}
