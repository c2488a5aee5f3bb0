package org.selectiverenderer.cli.view;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.cli.CommandTestCase;
import org.selectiverenderer.cli.Main;
import org.selectiverenderer.doctor.Diagnosis;
import org.selectiverenderer.doctor.Probe;
import org.selectiverenderer.doctor.run.Doctor;
import org.selectiverenderer.doctor.run.ProbeProcess;
import org.selectiverenderer.testing.RequiresDisplay;

/** The real probes of libraries; to make all of them as users do takes a process for each. */
class DoctorCommandTest extends CommandTestCase {
  private List<Diagnosis> probe(String name) {
    assertThat(execute("doctor", "--probe", name)).isZero();
    return printed()
        .lines()
        .map(line -> Diagnosis.read(line.substring(ProbeProcess.MARK.length())))
        .flatMap(Optional::stream)
        .toList();
  }

  @Test
  @RequiresDisplay
  void namesTheDriverAndMeasuresIt() {
    assertThat(probe("opengl")).extracting(Diagnosis::subject).containsExactly("JOGL", "OpenGL");
    assertThat(probe("speed"))
        .singleElement()
        .extracting(Diagnosis::found)
        .asString()
        .matches(
            "[0-9,.]*[1-9][0-9,.]* million triangles/s, [0-9,.]*[1-9][0-9,.]* million pixels/s.*");
    assertThat(probe("display"))
        .isNotEmpty()
        .allSatisfy(line -> assertThat(line.status()).isEqualTo(Diagnosis.Status.OK));
    assertThat(probe("stereo")).singleElement();
  }

  @Test
  void everyLibraryGivesALine() {
    for (String name : List.of("openxr", "serial", "lsl", "sound")) {
      assertThat(probe(name)).as(name).isNotEmpty().noneMatch(Diagnosis::fatal);
    }
  }

  @Test
  void theProgramStartsItselfForAProbe() throws InterruptedException {
    Doctor doctor =
        new Doctor(ProbeProcess.of(Main.class.getName(), List.of("doctor", "--probe")), "");
    Probe fonts =
        new Probe("fonts", "fonts", true, Probe.Place.APART, Duration.ofSeconds(60), found -> {});
    assertThat(doctor.examine(List.of(fonts)))
        .singleElement()
        .extracting(Diagnosis::subject)
        .isEqualTo("fonts");
  }

  @Test
  void aWrongProbeIsRefused() {
    assertThat(execute("doctor", "--probe", "moon")).isEqualTo(2);
    assertThat(messages()).contains("there is no probe moon");
  }
}
