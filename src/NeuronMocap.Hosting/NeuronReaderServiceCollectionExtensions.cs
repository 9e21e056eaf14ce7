using Microsoft.Extensions.Configuration;
using Microsoft.Extensions.DependencyInjection.Extensions;
using Microsoft.Extensions.Hosting;
using Microsoft.Extensions.Logging;
using Microsoft.Extensions.Options;
using NeuronMocap;
using NeuronMocap.Hosting;

namespace Microsoft.Extensions.DependencyInjection;

/// <summary>Puts readers into a host.</summary>
public static class NeuronReaderServiceCollectionExtensions
{
    /// <summary>Section of the configuration of the reader without a name.</summary>
    public const string Section = "NeuronReader";

    /// <summary>Section of the configuration with one section for each named reader.</summary>
    public const string NamedSection = "NeuronReaders";

    /// <summary>
    /// Adds a <see cref="NeuronReader"/> as a singleton, with the options of the configuration's section "NeuronReader" and the host's logs. It
    /// starts when all hosted services have started, so that what they open in their constructors or in StartAsync gets the first frame too
    /// (ExecuteAsync of a background service may run later), and stops as the host begins to stop. Options that are out of range keep the
    /// host from starting.
    /// </summary>
    /// <param name="services">The host's services.</param>
    /// <param name="configure">Sets options in code, after those of the configuration; null for none.</param>
    /// <returns>The services.</returns>
    public static IServiceCollection AddNeuronReader(this IServiceCollection services, Action<NeuronReaderOptions>? configure = null)
    {
        ArgumentNullException.ThrowIfNull(services);
        AddOptions(services, Microsoft.Extensions.Options.Options.DefaultName, Section, configure);
        services.TryAddSingleton(static provider => Create(provider, Microsoft.Extensions.Options.Options.DefaultName));
        return AddService(services, static provider => provider.GetRequiredService<NeuronReader>());
    }

    /// <summary>
    /// Adds one of several readers, as a keyed singleton: <c>[FromKeyedServices("left")] NeuronReader reader</c>. Its options are those of the
    /// configuration's section "NeuronReaders:left"; otherwise as <see cref="AddNeuronReader(IServiceCollection, Action{NeuronReaderOptions})"/>.
    /// </summary>
    /// <param name="services">The host's services.</param>
    /// <param name="name">Key of the service, and name of the reader in metrics and logs unless the options give another.</param>
    /// <param name="configure">Sets options in code, after those of the configuration; null for none.</param>
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
                    ReaderSettings.Apply(settings, name, options);
            });
        if (configure is not null)
            options.Configure(configure);

        options.ValidateOnStart();
    }

    // As a factory, because AddHostedService takes only one service of a type.
    private static IServiceCollection AddService(IServiceCollection services, Func<IServiceProvider, NeuronReader> reader) =>
        services.AddSingleton<IHostedService>(provider => new NeuronReaderService(reader(provider)));

    private static NeuronReader Create(IServiceProvider provider, string name) =>
        new(provider.GetRequiredService<IOptionsMonitor<NeuronReaderOptions>>().Get(name));
}
