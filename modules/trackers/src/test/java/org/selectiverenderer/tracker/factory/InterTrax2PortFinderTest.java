package org.selectiverenderer.tracker.factory;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.tracker.emulator.EmulatedInterTrax2;
import org.selectiverenderer.tracker.emulator.InterTrax2Emulator;
import org.selectiverenderer.tracker.emulator.PseudoTerminal;

@Timeout(value = 60, unit = TimeUnit.SECONDS)
class InterTrax2PortFinderTest {
  @TempDir private Path folder;

  @Test
  void thePortWhereOneAnswersIsFoundAndLetGoOf() throws IOException, InterruptedException {
    assumeTrue(
        Stream.of(PseudoTerminal.Maker.values()).anyMatch(PseudoTerminal.Maker::installed),
        "no program that makes pseudo-terminals is installed");
    Path silent = folder.resolve("silent");
    Path device = folder.resolve("tracker");
    try (PseudoTerminal nobody = PseudoTerminal.open(silent);
        EmulatedInterTrax2 tracker =
            EmulatedInterTrax2.start(
                device, new InterTrax2Emulator.Settings(120, (t, into) -> into.turn(1, 2, 3)))) {
      assertThat(nobody.output()).as("a port at which nothing answers").isNotNull();
      List<String> ports =
          List.of(folder.resolve("none").toString(), silent.toString(), tracker.link().toString());
      TrackerSpec found = new TrackerSpec.InterTrax2(device.toString());
      assertThat(InterTrax2PortFinder.among(ports, 30_000)).contains(found);
      assertThat(InterTrax2PortFinder.among(ports, 30_000)).as("open again").contains(found);
    }
  }

  @Test
  void whereNothingAnswersThereIsNone() throws InterruptedException {
    assertThat(InterTrax2PortFinder.among(List.of(), 30_000)).isEmpty();
    assertThat(InterTrax2PortFinder.among(List.of(folder.resolve("none").toString()), 30_000))
        .isEmpty();
  }

  @Test
  void whatNamesItsPortIsNotLookedFor() throws InterruptedException {
    TrackerSpec named = TrackerSpec.parse("intertrax2:/dev/ttyUSB7");
    assertThat(InterTrax2PortFinder.found(named)).contains(named);
    assertThat(TrackerSpec.parse("intertrax2:auto"))
        .isEqualTo(new TrackerSpec.InterTrax2("auto"))
        .hasToString("intertrax2:auto");
  }
}
