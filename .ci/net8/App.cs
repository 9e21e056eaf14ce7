using System.Runtime.InteropServices;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.DependencyInjection;
using NeuronDataReaderWraper;
using NeuronMocap;

Console.WriteLine(RuntimeInformation.FrameworkDescription);
Console.WriteLine($"{await Demo.ReceiveAsync(10)} frames");
if (args is ["library"])
    return;

await using ServiceProvider services = new ServiceCollection().AddNeuronReader(options => options.Name = "suit").BuildServiceProvider();
Console.WriteLine(services.GetRequiredService<NeuronReader>().Name);
Console.WriteLine(NeuronDataReader.BRGetSocketStatus(IntPtr.Zero));
