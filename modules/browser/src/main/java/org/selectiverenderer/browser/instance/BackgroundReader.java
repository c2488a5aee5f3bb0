package org.selectiverenderer.browser.instance;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import java.util.WeakHashMap;
import org.joml.Matrix4dc;
import org.joml.Quaterniond;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;

/**
 * Reads Background and TextureBackground nodes (X3D 4.0, 24.4.1, 24.4.5) and notices changes of
 * their textures' urls and pixels. Belongs to the thread that steps the world.
 */
public final class BackgroundReader {
  private final AssetProvider assets;

  /**
   * The url or pixels that each texture had when it was last read, since a background does not
   * observe its textures.
   */
  private final Map<Node, Object> seen = new WeakHashMap<>();

  public BackgroundReader(AssetProvider assets) {
    this.assets = assets;
  }

  /**
   * Reads a background. Angles without a colour and colours without an angle are left out; images
   * that are not loaded yet are missing.
   *
   * @param place the matrix from the background's coordinates to the world; only its rotation
   *     matters
   */
  public Background read(Node background, Matrix4dc place) {
    float[] sky = background.floats("skyColor");
    float[] ground = background.floats("groundColor");
    float[] skyAngle = background.floats("skyAngle");
    float[] groundAngle = background.floats("groundAngle");
    int skyBands = Math.min(sky.length / 3 - 1, skyAngle.length);
    int groundBands = Math.min(ground.length / 3 - 1, groundAngle.length);
    Quaterniond turn = place.getUnnormalizedRotation(new Quaterniond()).normalize();
    return new Background(
        skyBands < 0 ? Background.BLACK.skyColor() : Arrays.copyOf(sky, 3 * (skyBands + 1)),
        Arrays.copyOf(skyAngle, Math.max(0, skyBands)),
        groundBands < 0 ? new float[0] : Arrays.copyOf(ground, 3 * (groundBands + 1)),
        Arrays.copyOf(groundAngle, Math.max(0, groundBands)),
        background.number("transparency"),
        pictures(background),
        turn.isFinite() ? turn : new Quaterniond());
  }

  private Map<Background.Side, Texture.Image> pictures(Node background) {
    Map<Background.Side, Texture.Image> pictures = new EnumMap<>(Background.Side.class);
    for (Background.Side side : Background.Side.values()) {
      texture(background, side).flatMap(this::image).ifPresent(image -> pictures.put(side, image));
    }
    return pictures;
  }

  private Optional<Node> texture(Node background, Background.Side side) {
    if (!background.type().name().equals("TextureBackground")) {
      return assets.picture(background, side);
    }
    Optional<Node> texture = Optional.ofNullable(background.node(side.textureField()));
    return texture
        .filter(node -> node.type().name().equals("MultiTexture"))
        .map(node -> node.nodes("texture").stream().findFirst())
        .orElse(texture);
  }

  private Optional<Texture.Image> image(Node texture) {
    Optional<FieldDefinition> source =
        texture.type().field("url").or(() -> texture.type().field("image"));
    if (source.isPresent()) {
      Object now = texture.value(source.get().index());
      Object before = seen.put(texture, now);
      if (before != null && before != now) {
        assets.changed(texture);
      }
    }
    return assets.image(texture);
  }
}
