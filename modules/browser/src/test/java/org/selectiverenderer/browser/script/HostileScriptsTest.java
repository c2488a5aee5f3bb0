package org.selectiverenderer.browser.script;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Scripts that try to run on for ever, to take all memory, or to end the program. */
class HostileScriptsTest {
  private static final Path SCRIPTS = Path.of("src/test/resources/hostile/scripts");

  /** The limits are far below the real ones, and so is the time that the tests take. */
  private static final ScriptLimits LIMITS = new ScriptLimits(0.04, 0.05, 48 << 20);

  private static ScriptLimits counted() {
    return ScriptFixture.countedLimits(LIMITS.callSeconds(), LIMITS.startSeconds(), LIMITS.bytes());
  }

  private static final String SCENE =
      """
      <Script DEF='Hostile'>
      <field name='numbers' type='MFFloat' accessType='inputOutput'/>
      <field name='images' type='MFImage' accessType='inputOutput'/>
      <![CDATA[ecmascript:%s]]></Script>
      <Script DEF='Harmless'>
      <field name='go' type='SFInt32' accessType='inputOnly'/>
      <field name='out' type='SFString' accessType='outputOnly'/>
      <![CDATA[ecmascript: function go(v) { out = 'v' + v; } ]]></Script>
      """;

  static Stream<String> scripts() throws IOException {
    try (Stream<Path> files = Files.list(SCRIPTS)) {
      return files.map(file -> file.getFileName().toString()).sorted().toList().stream();
    }
  }

  @ParameterizedTest
  @MethodSource("scripts")
  void endsThatScriptOnly(String name) throws IOException {
    String program = Files.readString(SCRIPTS.resolve(name));
    assertTimeoutPreemptively(Duration.ofSeconds(20), () -> endsThatScriptOnly(name, program));
  }

  private static void endsThatScriptOnly(String name, String program) throws IOException {
    try (ScriptFixture scene = new ScriptFixture(SCENE.formatted(program), LIMITS)) {
      scene.scripts().prepare(1, new Vector3d());
      scene.go(1, 7);

      assertThat(scene.out(1)).isEqualTo("v7");
      List<String> told =
          scene.told().stream().filter(line -> !line.contains(" prints: ")).toList();
      assertThat(told).as(name).singleElement().asString().contains("Script Hostile: ");
    }
  }

  @Test
  void scriptsThatAllStartForeverEndTogether() throws IOException {
    String endless = "<Script><![CDATA[ecmascript: for (;;) { }]]></Script>";
    String harmless =
        "<Script><field name='go' type='SFInt32' accessType='inputOnly'/>"
            + "<field name='out' type='SFString' accessType='outputOnly'/>"
            + "<![CDATA[ecmascript: function go(v) { out = 'v' + v; } ]]></Script>";
    try (ScriptFixture scene =
        new ScriptFixture(
            harmless + endless.repeat(200), counted(), new ScriptTimeBudget(1, 0.12))) {
      scene.go(7);

      assertThat(scene.out()).isEqualTo("v7"); // It had started before.
      assertThat(scene.told())
          .hasSize(4) // Three endless scripts and the budget, not 200.
          .last()
          .asString()
          .contains("the scripts of the scene have taken more than 0 s to start");
    }
  }

  @Test
  void aSceneThatReplacesAnotherHasOnlyTheTimeThatIsLeft() throws IOException {
    String endless = "<Script><![CDATA[ecmascript: for (;;) { }]]></Script>";
    ScriptTimeBudget budget = new ScriptTimeBudget(1, 0.12);
    new ScriptFixture(endless.repeat(2), counted(), budget).close();
    new ScriptFixture(endless.repeat(2), counted(), budget).close();

    try (ScriptFixture third = new ScriptFixture(endless.repeat(2), counted(), budget)) {
      assertThat(third.told()).isEmpty(); // Nothing ran that could be told of.
    }
  }

  @Test
  void callsThatAllTakeTheirTimeAreDroppedInTheEnd() throws IOException {
    String slow =
        "<Script><field name='go' type='SFInt32' accessType='inputOnly'/>"
            + "<field name='out' type='SFInt32' accessType='outputOnly'/><![CDATA[ecmascript:"
            + "var n = 0; function go() { out = ++n; for (var i = 0; i < 20000; i++) { } }"
            + "]]></Script>";
    try (ScriptFixture scene =
        new ScriptFixture(
            slow, ScriptFixture.countedLimits(1, 5, 1 << 30), new ScriptTimeBudget(0.1, 1))) {
      for (int call = 0; call < 300; call++) {
        scene.go(call);
      }

      assertThat((int) scene.out()).isBetween(1, 200);
      assertThat(scene.told())
          .singleElement()
          .asString()
          .contains("events to them are dropped until it has caught up");
    }
  }
}
