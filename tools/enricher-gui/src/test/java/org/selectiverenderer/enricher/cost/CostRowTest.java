package org.selectiverenderer.enricher.cost;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.polygon.IncrementalSceneCounter;
import org.selectiverenderer.polygon.IncrementalSceneCounter.CountResult;
import org.selectiverenderer.polygon.RenderingCost;
import org.selectiverenderer.validation.CostBudget;
import org.selectiverenderer.validation.CostKind;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/** What rows say of textures and draw calls. */
class CostRowTest {
  private static final String SCENE =
      "<X3D profile='Immersive' version='4.0'><Scene>"
          + "<Shape><Appearance><ImageTexture url='\"a.png\"'/></Appearance><Box/></Shape>"
          + "<Shape><Box/></Shape></Scene></X3D>";

  @TempDir Path folder;

  @Test
  void texturesAndDrawCallsOverTheirLimitsHaveASign() throws IOException {
    ImageIO.write(
        new BufferedImage(2, 2, BufferedImage.TYPE_INT_RGB),
        "png",
        folder.resolve("a.png").toFile());
    CountResult counted =
        new IncrementalSceneCounter()
            .count(
                folder.resolve("scene.x3d"),
                "scene.x3d",
                SCENE.getBytes(StandardCharsets.UTF_8),
                ContentAccessPolicy.none());
    CostBudget budget =
        new CostBudget(
            "", "", List.of(), Map.of(CostKind.TEXTURE_BYTES, 19L, CostKind.DRAW_CALLS, 2L));
    List<CostRow> rows = CostRow.of(counted, List.of(budget));
    CostRow worst =
        rows.stream().filter(row -> row.kind() == CostRow.Kind.WORST).findFirst().orElseThrow();
    assertThat(worst.cost()).isEqualTo(new RenderingCost(2, 20));
    assertThat(CostFormatter.textures(worst)).isEqualTo("\u25b2 20 B");
    assertThat(CostFormatter.draws(worst)).isEqualTo("2");
    assertThat(CostFormatter.costTip(worst, CostKind.TEXTURE_BYTES)).endsWith("Limit: 19 B");
    assertThat(worst.broken()).isFalse(); // there is no limit of polygons
    assertThat(CostFormatter.verdict(worst)).isEmpty();
    assertThat(rows.get(0).cost()).isEqualTo(new RenderingCost(2, 20));
  }
}
