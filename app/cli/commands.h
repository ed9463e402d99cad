#pragma once

#include <cstdint>

namespace CLI {
class App;
}

namespace espalier {

// Each adds its subcommand, to be run when the arguments name it.
void addReconstruct(CLI::App& app);
void addBatch(CLI::App& app);
void addContract(CLI::App& app);
void addClean(CLI::App& app);
void addSmooth(CLI::App& app);
void addPlants(CLI::App& app);
void addRegister(CLI::App& app);
void addSweep(CLI::App& app);
void addEvaluate(CLI::App& app);
void addTraits(CLI::App& app);
void addEnvelope(CLI::App& app);
void addConsensus(CLI::App& app);
void addNoise(CLI::App& app);
void addConvert(CLI::App& app);
void addInfo(CLI::App& app);
void addSimulate(CLI::App& app);
void addMethods(CLI::App& app);
void addManual(CLI::App& app);
void addPicture(CLI::App& app);
void addAnswer(CLI::App& app);

} // namespace espalier
