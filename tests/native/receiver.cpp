// A typical C++98 program: objects receive the callbacks. receiver PORT FRAMES prints what the objects received.
#include <NeuronDataReader.h>

#include <pthread.h>
#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <map>
#include <string>
#include <vector>

class Lock
{
public:
    explicit Lock(pthread_mutex_t &mutex) : mutex_(mutex) { pthread_mutex_lock(&mutex_); }
    ~Lock() { pthread_mutex_unlock(&mutex_); }

private:
    Lock(const Lock &);
    Lock &operator=(const Lock &);

    pthread_mutex_t &mutex_;
};

// The frames of each avatar.
class Recorder
{
public:
    Recorder() : calculations_(0)
    {
        pthread_mutex_init(&mutex_, NULL);
        pthread_cond_init(&changed_, NULL);
    }

    virtual ~Recorder()
    {
        pthread_cond_destroy(&changed_);
        pthread_mutex_destroy(&mutex_);
    }

    void WaitFor(std::size_t frames)
    {
        Lock lock(mutex_);
        while (Count() < frames)
            pthread_cond_wait(&changed_, &mutex_);
    }

    void Print()
    {
        Lock lock(mutex_);
        for (std::map<std::string, std::vector<float> >::const_iterator avatar = frames_.begin(); avatar != frames_.end(); ++avatar)
            std::cout << avatar->first << ' ' << avatar->second.size() << ' ' << avatar->second.back() << std::endl;
        std::cout << "calculations " << calculations_ << std::endl;
    }

    virtual void OnFrame(const BvhDataHeader &header, const float *data)
    {
        Lock lock(mutex_);
        frames_[reinterpret_cast<const char *>(header.AvatarName)].push_back(data[header.DataCount - 1]);
        pthread_cond_signal(&changed_);
    }

    virtual void OnCalculation(const CalcDataHeader &, const float *)
    {
        Lock lock(mutex_);
        calculations_++;
        pthread_cond_signal(&changed_);
    }

private:
    std::size_t Count() const
    {
        std::size_t count = calculations_;
        for (std::map<std::string, std::vector<float> >::const_iterator avatar = frames_.begin(); avatar != frames_.end(); ++avatar)
            count += avatar->second.size();
        return count;
    }

    pthread_mutex_t mutex_;
    pthread_cond_t changed_;
    std::map<std::string, std::vector<float> > frames_;
    std::size_t calculations_;
};

class Client
{
public:
    explicit Client(Recorder &recorder) : socket_(NULL)
    {
        ::BRRegisterSocketStatusCallback(this, &Client::OnStatus);
        ::BRRegisterFrameDataCallback(&recorder, &Client::OnFrame);
        ::BRRegisterCalculationDataCallback(&recorder, &Client::OnCalculation);
    }

    ~Client()
    {
        ::BRCloseSocket(socket_);
        ::BRRegisterFrameDataCallback(NULL, NULL);
        ::BRRegisterCalculationDataCallback(NULL, NULL);
        ::BRRegisterSocketStatusCallback(NULL, NULL);
    }

    bool Connect(const std::string &host, int port)
    {
        socket_ = ::BRConnectTo(host.c_str(), port);
        return socket_ != NULL && ::BRGetSocketStatus(socket_) == CS_Running;
    }

private:
    static void CALLBACK OnFrame(void *customedObj, SOCKET_REF, BvhDataHeader *header, float *data)
    {
        static_cast<Recorder *>(customedObj)->OnFrame(*header, data);
    }

    static void CALLBACK OnCalculation(void *customedObj, SOCKET_REF, CalcDataHeader *header, float *data)
    {
        static_cast<Recorder *>(customedObj)->OnCalculation(*header, data);
    }

    static void CALLBACK OnStatus(void *customedObj, SOCKET_REF sender, SocketStatus status, char *message)
    {
        if (static_cast<Client *>(customedObj)->socket_ == sender)
            std::cout << status << ' ' << message;
    }

    SOCKET_REF socket_;
};

int main(int argc, char **argv)
{
    alarm(120);
    if (argc < 3)
        return 2;
    Recorder recorder;
    {
        Client client(recorder);
        if (!client.Connect("localhost", std::atoi(argv[1])))
            return 1;
        recorder.WaitFor(static_cast<std::size_t>(std::atoi(argv[2])));
    }
    recorder.Print();
    return 0;
}
