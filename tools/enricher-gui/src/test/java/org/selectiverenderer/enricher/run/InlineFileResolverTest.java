package org.selectiverenderer.enricher.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;

/** Which file an Inline means. */
class InlineFileResolverTest {
  @TempDir Path folder;

  @Test
  void theFirstUrlThatIsThereOfTheInlineOrOfWhatHoldsIt() throws IOException {
    Path chair = Files.writeString(folder.resolve("chair.x3d"), "<X3D/>").toRealPath();
    EnricherSession session =
        TestSessions.with(
            folder,
            """
            <Switch DEF='A'><Inline DEF='I' url='"gone.x3d" "chair.x3d"'/></Switch>
            <Inline DEF='Gone' url='gone.x3d'/>
            <Group DEF='Empty'/>
            """);
    assertThat(answer(session, "A").file()).contains(chair);
    assertThat(answer(session, "I").file()).contains(chair);
    assertThat(answer(session, "Gone").file()).isEmpty();
    assertThat(answer(session, "Gone").reason()).startsWith("gone.x3d ");
    assertThat(answer(session, "Empty").reason()).contains("Choose an Inline");
  }

  private static InlineFileResolver.Answer answer(EnricherSession session, String def) {
    return InlineFileResolver.of(
        session, session.document().tree().orElseThrow().named(def).orElseThrow());
  }
}
