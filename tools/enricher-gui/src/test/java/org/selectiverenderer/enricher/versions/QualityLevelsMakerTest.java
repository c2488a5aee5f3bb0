package org.selectiverenderer.enricher.versions;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.enrichment.EnrichedField;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.qualities.QualityVersionsEdit;
import org.selectiverenderer.enricher.EventThread;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.testing.Eventually;

class QualityLevelsMakerTest {
  @TempDir Path folder;

  @Test
  void picturesAndLevelsAreOneStep() throws IOException {
    ImageIO.write(
        new BufferedImage(8, 8, BufferedImage.TYPE_INT_RGB),
        "png",
        folder.resolve("wood.png").toFile());
    EnricherSession session =
        TestSessions.with(
            folder,
            """
            <Switch DEF='Switch_Chest' whichChoice='0'>
              <Shape><Appearance><ImageTexture url='"wood.png"'/></Appearance><Box/></Shape>
            </Switch>
            """);
    String before = EventThread.get(() -> session.document().text().toString());
    EventThread.edt(
        () ->
            new QualityLevelsMaker(session)
                .make(
                    new QualityVersionsEdit.Request(
                        "Switch_Chest", List.of(50.0), List.of("flat"), List.of())));
    Eventually.await("the levels", () -> EventThread.get(() -> session.document().revision() > 0));
    EnrichedSwitch chest = EventThread.get(() -> session.enrichment().switches().get(0));
    assertThat(chest.fields()).hasSize(2);
    assertThat(chest.fields().get(0).levels())
        .extracting(EnrichedField.Level::values)
        .containsExactly(List.of("wood.png"), List.of("wood_50.png"));
    assertThat(ImageIO.read(folder.resolve("wood_50.png").toFile()).getWidth()).isEqualTo(4);
    assertThat(EventThread.get(() -> session.document().history().undoName()))
        .contains("Set qualities of Switch_Chest");
    EventThread.edt(() -> session.document().history().undo());
    assertThat(EventThread.get(() -> session.document().text().toString())).isEqualTo(before);
    assertThat(Files.exists(folder.resolve("wood_50.png"))).isFalse();
    EventThread.edt(session::dispose);
  }

  @Test
  void percentsFallFromBelowAHundred() {
    assertThat(QualityLevelsMaker.percents("50, 25")).contains(List.of(50.0, 25.0));
    assertThat(QualityLevelsMaker.percents("50 % 12.5 %")).contains(List.of(50.0, 12.5));
    assertThat(QualityLevelsMaker.percents(" ")).contains(List.of());
    assertThat(QualityLevelsMaker.percents("25, 50")).isEqualTo(Optional.empty());
    assertThat(QualityLevelsMaker.percents("100")).isEqualTo(Optional.empty());
    assertThat(QualityLevelsMaker.percents("half")).isEqualTo(Optional.empty());
  }
}
