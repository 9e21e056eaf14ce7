#define NEURONDATAREADER_B12
#include <NeuronDataReader.h>

#include "old_functions.h"

int ask_old_functions(void *handle)
{
    return BRCommandFetchDataFromServer(handle, Cmd_AvatarCount) + BRCommandFetchAvatarDataFromServer(handle, 0, Cmd_BoneSize)
        + BRRegisterAutoSyncParmeter(handle, Cmd_CombinationMode) + BRUnregisterAutoSyncParmeter(handle, Cmd_CombinationMode);
}
