package org.selectiverenderer.render.draw;

import com.jogamp.opengl.GL3;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import org.joml.Matrix4f;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.ExtendedMaterial;
import org.selectiverenderer.browser.instance.LightInstance;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.instance.SurfaceMaterial;
import org.selectiverenderer.browser.instance.SurfaceShading;
import org.selectiverenderer.browser.instance.Texture;
import org.selectiverenderer.browser.instance.TextureSource;
import org.selectiverenderer.browser.instance.TextureUnit;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.render.gpu.GpuTexture;
import org.selectiverenderer.render.gpu.MaterialBinding;
import org.selectiverenderer.render.gpu.MaterialDefines;
import org.selectiverenderer.render.gpu.ShaderVariant;
import org.selectiverenderer.render.gpu.ShapeProgramCache;
import org.selectiverenderer.render.gpu.TextureFilterQuality;
import org.selectiverenderer.render.mesh.MeshPacker;
import org.selectiverenderer.render.mesh.VertexLayout;

/**
 * The draw states of shapes with their programs, textures and lights, each kept once however many
 * shapes share it.
 */
final class DrawStateCache {
  private static final float[] NO_TRANSFORM = {1, 0, 0, 0, 1, 0, 0, 0, 1};

  private final Map<TextureSource, GpuTexture> textures = new HashMap<>();
  private final ShapeProgramCache programs = new ShapeProgramCache();
  private final CustomShaderCache authors = new CustomShaderCache();
  private final Map<State, Integer> ranks = new HashMap<>();
  private final Map<List<LightInstance>, List<LightInstance>> lists = new HashMap<>();
  private final Map<DrawState, DrawState> known = new HashMap<>();
  private final TextureFilterQuality filters;
  private long uploads;

  /** A program and texture, by which the drawing order is sorted. */
  private record State(ShapeProgramCache.Family programs, @Nullable GpuTexture texture) {
    // Written out, as records link theirs when first called: the first frame would wait for it.
    @Override
    public boolean equals(@Nullable Object other) {
      return other instanceof State one
          && programs.equals(one.programs)
          && Objects.equals(texture, one.texture);
    }

    @Override
    public int hashCode() {
      return 31 * programs.hashCode() + Objects.hashCode(texture);
    }
  }

  DrawStateCache(TextureFilterQuality filters) {
    this.filters = filters;
  }

  /** Returns the number of textures uploaded since the start. */
  long uploads() {
    return uploads;
  }

  /** Returns one shared list object for all shapes with equal lists. */
  List<LightInstance> shared(List<LightInstance> reaching) {
    return lists.computeIfAbsent(reaching, list -> list);
  }

  /**
   * Returns the draw state of a shape and uploads its texture unless it is there. Equal states are
   * the same object, so that their uniforms are sent once.
   *
   * @param drawn the shape's mesh or a refined one
   * @param reaching the lights that reach it, as returned by {@link #shared}
   */
  DrawState of(GL3 gl, ShapeInstance shape, Mesh drawn, List<LightInstance> reaching) {
    SurfaceMaterial surface = shape.surface();
    CustomShaderBinding author =
        shape.programs().isEmpty()
            ? null
            : authors.choose(gl, shape, drawn, source -> texture(gl, source));
    if (author != null) {
      return authored(gl, shape, drawn, reaching, author);
    }
    if (surface.detail() != null && drawn.primitive() == Mesh.Primitive.TRIANGLES) {
      return detailed(gl, shape, surface.detail(), drawn, reaching);
    }
    Texture image = surface.glow() == null ? surface.texture() : surface.glow();
    GpuTexture texture =
        image == null
                || !drawn.hasTexCoords()
                || drawn.primitive() == Mesh.Primitive.LINES // Lengths along the line.
            ? null
            : texture(gl, image);
    boolean blended = blended(surface, drawn, texture);
    ShaderVariant variant = variant(drawn, surface, texture, blended, List.of());
    float[] transform = surface.textureTransform();
    DrawState look =
        new DrawState(
            programs.get(variant),
            programs.get(variant.lit(true)),
            texture,
            reaching,
            new FloatArrayKey(numbers(surface)),
            new FloatArrayKey(transform == null ? NO_TRANSFORM : transform),
            blended,
            VertexLayout.of(drawn),
            shape.stroke(),
            shape.surroundings(),
            drawn.primitive(),
            drawn.solid(),
            null,
            null);
    return known.computeIfAbsent(look, same -> same);
  }

  private GpuTexture texture(GL3 gl, TextureSource source) {
    return textures.computeIfAbsent(
        source,
        image -> {
          uploads++;
          return new GpuTexture(
              gl, GeneratedCubeMapRenderer.fitting(image, textures.values()), filters);
        });
  }

  private DrawState detailed(
      GL3 gl,
      ShapeInstance shape,
      ExtendedMaterial detail,
      Mesh drawn,
      List<LightInstance> reaching) {
    SurfaceMaterial surface = shape.surface();
    List<GpuTexture> images = new ArrayList<>();
    detail.units().forEach(unit -> images.add(texture(gl, unit.source())));
    boolean blended =
        MaterialAlphaMode.blended(surface, detail, images, MeshPacker.translucent(drawn));
    boolean cutOut = MaterialAlphaMode.cutOut(detail, images);
    ShaderVariant variant =
        variant(
            drawn,
            surface,
            null,
            blended,
            MaterialDefines.of(
                detail, surface.tints(), coordinates(drawn), drawn.tangents(), cutOut));
    SurfaceMaterial back = detail.back();
    MaterialBinding textured =
        new MaterialBinding(
            List.copyOf(images),
            TextureMatrices.of(detail.units(), drawn.bounds()),
            detail.numbers(),
            back == null ? null : numbers(back),
            cutOut || detail.alphaMode() == ExtendedMaterial.AlphaMode.MASK);
    ShapeProgramCache.Family family = programs.get(variant);
    return whole(family, shape, drawn, reaching, blended, textured, null);
  }

  /**
   * Returns the draw state of a shape with a custom shader: only the opacity of its surface counts
   * here.
   */
  private DrawState authored(
      GL3 gl,
      ShapeInstance shape,
      Mesh drawn,
      List<LightInstance> reaching,
      CustomShaderBinding author) {
    SurfaceMaterial surface = shape.surface();
    ExtendedMaterial detail = surface.detail();
    boolean blended =
        detail == null || detail.alphaMode() == ExtendedMaterial.AlphaMode.AUTO
            ? blended(
                surface, drawn, surface.texture() == null ? null : texture(gl, surface.texture()))
            : detail.alphaMode() == ExtendedMaterial.AlphaMode.BLEND;
    ShapeProgramCache.Family family =
        programs.get(variant(drawn, surface, null, blended, List.of()));
    return whole(family, shape, drawn, reaching, blended, null, author);
  }

  /**
   * Returns a draw state with per-pixel lighting only, whose textures are all in the material
   * binding or the custom shader.
   */
  private DrawState whole(
      ShapeProgramCache.Family family,
      ShapeInstance shape,
      Mesh drawn,
      List<LightInstance> reaching,
      boolean blended,
      @Nullable MaterialBinding textured,
      @Nullable CustomShaderBinding author) {
    DrawState look =
        new DrawState(
            family,
            family,
            null,
            reaching,
            new FloatArrayKey(numbers(shape.surface())),
            new FloatArrayKey(NO_TRANSFORM),
            blended,
            VertexLayout.of(drawn),
            shape.stroke(),
            shape.surroundings(),
            drawn.primitive(),
            drawn.solid(),
            textured,
            author);
    known.put(look, look);
    return look;
  }

  /** Returns the number of components of each of the mesh's further texture coordinates. */
  private static List<Integer> coordinates(Mesh mesh) {
    return mesh.moreTexCoords().stream()
        .filter(more -> more.name().isEmpty())
        .map(Mesh.TexCoords::components)
        .toList();
  }

  /** Returns the state's place in the drawing order. */
  int rank(DrawState look) {
    return ranks.computeIfAbsent(new State(look.byPixel(), look.texture()), state -> ranks.size());
  }

  /** Returns the same state for batches whose vertices store the diffuse colour. */
  DrawState tinted(DrawState look) {
    return look.drawnBy(programs.tinted(look.byPixel()), programs.tinted(look.byVertex()));
  }

  private static boolean blended(SurfaceMaterial surface, Mesh mesh, @Nullable GpuTexture texture) {
    return surface.transparency() > 0
        || MeshPacker.translucent(mesh)
        || (texture != null
            && surface.glow() == null
            && texture.alpha() == GpuTexture.Alpha.BLENDED);
  }

  private static ShaderVariant variant(
      Mesh mesh,
      SurfaceMaterial surface,
      @Nullable GpuTexture texture,
      boolean blended,
      List<String> detail) {
    SurfaceMaterial back = surface.detail() == null ? null : surface.detail().back();
    boolean shiny = shiny(surface) || (back != null && shiny(back));
    return new ShaderVariant(
        surface.lit() && mesh.normals() != null,
        shiny,
        false,
        surface.shading() == SurfaceShading.FLAT,
        mesh.colors() != null,
        texture != null,
        surface.tints(),
        surface.glow() != null,
        texture != null && texture.alpha() == GpuTexture.Alpha.CUT_OUT,
        !mesh.solid(),
        mesh.primitive() == Mesh.Primitive.POINTS,
        blended,
        false,
        detail);
  }

  private static boolean shiny(SurfaceMaterial surface) {
    float[] specular = surface.specular();
    return specular[0] > 0 || specular[1] > 0 || specular[2] > 0;
  }

  private static float[] numbers(SurfaceMaterial surface) {
    float[] d = surface.diffuse();
    float[] e = surface.emissive();
    float[] s = surface.specular();
    return new float[] {
      d[0],
      d[1],
      d[2],
      1 - surface.transparency(),
      e[0],
      e[1],
      e[2],
      surface.ambientIntensity(),
      s[0],
      s[1],
      s[2],
      surface.shininess() * 128
    };
  }

  /** Frees the resources that none of the items uses. */
  void keepOnly(GL3 gl, List<DrawItem> items) {
    Set<GpuTexture> used = new HashSet<>();
    // Compared by identity: each shared list and each state's material array is one object.
    Set<List<LightInstance>> usedLists = Collections.newSetFromMap(new IdentityHashMap<>());
    Set<float[]> usedNumbers = Collections.newSetFromMap(new IdentityHashMap<>());
    for (DrawItem item : items) {
      used.add(item.texture());
      if (item.detail() != null) {
        used.addAll(item.detail().textures());
      }
      if (item.author() != null) {
        item.author().textures().forEach(texture -> texture.ifPresent(used::add));
      }
      usedLists.add(item.lighting().reaching());
      usedNumbers.add(item.numbers());
    }
    lists.values().removeIf(list -> !usedLists.contains(list));
    known.keySet().removeIf(look -> !usedNumbers.contains(look.material().array()));
    textures
        .values()
        .removeIf(
            texture -> {
              boolean unused = !used.contains(texture);
              if (unused) {
                texture.dispose(gl);
              }
              return unused;
            });
    authors.keepOnly(gl, items);
    ranks.keySet().removeIf(state -> state.texture() != null && !used.contains(state.texture()));
  }

  void dispose(GL3 gl) {
    keepOnly(gl, List.of());
    authors.close();
    programs.dispose(gl);
  }

  /** Computes the matrices by which a shader multiplies texture coordinates. */
  private static final class TextureMatrices {
    private TextureMatrices() {}

    /**
     * @param bounds of the mesh: min x, y, z, max x, y, z
     * @return sixteen numbers per unit
     */
    static float[] of(List<TextureUnit> units, float[] bounds) {
      float[] all = new float[16 * units.size()];
      for (int i = 0; i < units.size(); i++) {
        TextureUnit unit = units.get(i);
        Matrix4f matrix = new Matrix4f().set(unit.matrix());
        if (unit.set() == TextureUnit.BOUNDS) {
          boolean cube = unit.source().cube();
          matrix.mul(cube ? aroundMiddle(bounds) : through(bounds));
        }
        matrix.get(all, 16 * i);
      }
      return all;
    }

    /** Returns the map to coordinates from 0 to 1 along each side of the bounding box. */
    private static Matrix4f through(float[] b) {
      return new Matrix4f()
          .scale(share(b[3] - b[0]), share(b[4] - b[1]), share(b[5] - b[2]))
          .translate(-b[0], -b[1], -b[2]);
    }

    private static float share(float side) {
      return side > 0 ? 1 / side : 0;
    }

    /** Returns the map to directions from the centre of the bounding box. */
    private static Matrix4f aroundMiddle(float[] b) {
      return new Matrix4f().translation(-(b[0] + b[3]) / 2, -(b[1] + b[4]) / 2, -(b[2] + b[5]) / 2);
    }
  }
}
