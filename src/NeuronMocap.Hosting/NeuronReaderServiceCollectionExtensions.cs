using Microsoft.Extensions.Configuration;
using Microsoft.Extensions.DependencyInjection.Extensions;
using Microsoft.Extensions.Hosting;
using Microsoft.Extensions.Logging;
using Microsoft.Extensions.Options;
using NeuronMocap;
using NeuronMocap.Hosting;

namespace Microsoft.Extensions.DependencyInjection;

/// <summary>Extension methods that add readers to a host.</summary>
public static class NeuronReaderServiceCollectionExtensions
{
    /// <summary>Configuration section of the reader without a name.</summary>
    public const string Section = "NeuronReader";

    /// <summary>Configuration section that holds one section for each named reader.</summary>
    public const string NamedSection = "NeuronReaders";

    /// <summary>
    /// Adds a <see cref="NeuronReader"/> as a singleton, with the options of the configuration section "NeuronReader" and the host's logs.
    /// </summary>
    /// <remarks>
    /// The reader starts when all hosted services have started. Consumers that they open in their constructors or in StartAsync therefore get the
    /// first frame. ExecuteAsync of a background service may run later. The reader stops when the host begins to stop. If an option is out of range,
    /// the host does not start.
    /// </remarks>
    /// <param name="services">The services of the host.</param>
    /// <param name="configure">Sets options in code, after those of the configuration; may be null.</param>
    /// <returns>The services.</returns>
    public static IServiceCollection AddNeuronReader(this IServiceCollection services, Action<NeuronReaderOptions>? configure = null)
    {
        ArgumentNullException.ThrowIfNull(services);
        AddOptions(services, Microsoft.Extensions.Options.Options.DefaultName, Section, configure);
        services.TryAddSingleton(static provider => Create(provider, Microsoft.Extensions.Options.Options.DefaultName));
        return AddService(services, static provider => provider.GetRequiredService<NeuronReader>());
    }

    /// <summary>
    /// Adds one of several readers, as a keyed singleton: <c>[FromKeyedServices("left")] NeuronReader reader</c>.
    /// </summary>
    /// <remarks>
    /// The options of this reader come from the configuration section "NeuronReaders:left". Otherwise the method works like
    /// <see cref="AddNeuronReader(IServiceCollection, Action{NeuronReaderOptions})"/>.
    /// </remarks>
    /// <param name="services">The services of the host.</param>
    /// <param name="name">Key of the service. Also the name of the reader in metrics and logs, unless the options set another one.</param>
    /// <param name="configure">Sets options in code, after those of the configuration; may be null.</param>
    /// <returns>The services.</returns>
    /// <exception cref="ArgumentException">The name is empty.</exception>
    public static IServiceCollection AddNeuronReader(this IServiceCollection services, string name, Action<NeuronReaderOptions>? configure = null)
    {
        ArgumentNullException.ThrowIfNull(services);
        ArgumentException.ThrowIfNullOrWhiteSpace(name);
        AddOptions(services, name, $"{NamedSection}:{name}", configure);
        services.TryAddKeyedSingleton(name, static (provider, key) => Create(provider, (string)key!));
        return AddService(services, provider => provider.GetRequiredKeyedService<NeuronReader>(name));
    }

    private static void AddOptions(IServiceCollection services, string name, string section, Action<NeuronReaderOptions>? configure)
    {
        services.TryAddEnumerable(ServiceDescriptor.Singleton<IValidateOptions<NeuronReaderOptions>, NeuronReaderOptionsValidator>());
        OptionsBuilder<NeuronReaderOptions> options = services.AddOptions<NeuronReaderOptions>(name)
            .Configure<IServiceProvider>((options, provider) =>
            {
                if (name.Length > 0)
                    options.Name = name;

                options.LoggerFactory = provider.GetService<ILoggerFactory>();
                if (provider.GetService<IConfiguration>()?.GetSection(section) is { } settings)
                    ReaderSettings.Apply(settings, name, provider.GetService<IHostEnvironment>()?.ContentRootPath ?? string.Empty, options);
            });
        if (configure is not null)
            options.Configure(configure);

        options.ValidateOnStart();
    }

    // Uses a factory, because AddHostedService accepts only one service of a type.
    private static IServiceCollection AddService(IServiceCollection services, Func<IServiceProvider, NeuronReader> reader) =>
        services.AddSingleton<IHostedService>(provider => new NeuronReaderService(reader(provider)));

    private static NeuronReader Create(IServiceProvider provider, string name) =>
        new(provider.GetRequiredService<IOptionsMonitor<NeuronReaderOptions>>().Get(name));
}
