package org.selectiverenderer.browser.sai;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import javax.xml.transform.TransformerException;
import javax.xml.transform.TransformerFactory;
import javax.xml.transform.dom.DOMSource;
import javax.xml.transform.stream.StreamResult;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.Scene;
import org.web3d.x3d.sai.ComponentInfo;
import org.web3d.x3d.sai.InvalidDocumentException;
import org.web3d.x3d.sai.InvalidURLException;
import org.web3d.x3d.sai.InvalidX3DException;
import org.web3d.x3d.sai.NotSupportedException;
import org.web3d.x3d.sai.ProfileInfo;
import org.web3d.x3d.sai.X3DNode;

/**
 * Makes scenes and nodes for an application: empty ones, or from text, streams, URLs and DOM
 * documents. Problems of what is read are reported to the world; a scene is refused when it has
 * problems and no node.
 */
final class SceneFactory {
  private static final SourceLocation MADE = SourceLocation.of("(made by the application)");

  private final SaiContext binding;
  private final SceneLoader loader;
  private final BrowserCapabilities infos;

  SceneFactory(SaiContext binding, SceneLoader loader, BrowserCapabilities infos) {
    this.binding = binding;
    this.loader = loader;
    this.infos = infos;
  }

  /** Returns the profile of a scene; null if the file leaves it out or misspells it. */
  @Nullable ProfileInfo profile(String name) {
    return infos.knows(name) ? infos.profile(name) : null;
  }

  /** Makes a node of a type, not realized; empty if there is no such type. */
  Optional<X3DNode> node(String type) {
    return loader
        .catalogue()
        .find(type)
        .map(found -> binding.wrapNew(loader.factory().make(found, null, MADE)));
  }

  EmbeddedScene empty(ProfileInfo profile, ComponentInfo @Nullable [] components) {
    Map<String, Integer> levels = new LinkedHashMap<>();
    try {
      infos.profile(profile.getName());
      for (ComponentInfo wanted : components == null ? new ComponentInfo[0] : components) {
        ComponentInfo component = infos.component(wanted.getName(), wanted.getLevel());
        levels.put(component.getName(), component.getLevel());
      }
    } catch (NotSupportedException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
    Node root = loader.factory().make(loader.catalogue().get("Group"), null, MADE);
    Scene scene = new Scene(root, "", "4.0", profile.getName(), levels, 1);
    return new EmbeddedScene(binding, this, scene, "");
  }

  EmbeddedScene fromText(String text) {
    try {
      return read("(text of the application)", bytes(text.getBytes(StandardCharsets.UTF_8)), "");
    } catch (IOException e) {
      throw new InvalidX3DException(e.getMessage());
    }
  }

  EmbeddedScene fromStream(String baseUrl, InputStream stream) throws IOException {
    return read(baseUrl.isBlank() ? "(stream of the application)" : baseUrl, stream, baseUrl);
  }

  EmbeddedScene fromDocument(org.w3c.dom.@Nullable Node element) {
    if (element == null) {
      throw new InvalidDocumentException("a document is needed, not null");
    }
    ByteArrayOutputStream text = new ByteArrayOutputStream();
    try {
      TransformerFactory.newInstance()
          .newTransformer()
          .transform(new DOMSource(element), new StreamResult(text));
      return read("(document of the application)", bytes(text.toByteArray()), "");
    } catch (TransformerException | IOException | InvalidX3DException e) {
      throw new InvalidDocumentException(e.getMessage());
    }
  }

  private static InputStream bytes(byte[] bytes) {
    return new ByteArrayInputStream(bytes);
  }

  private EmbeddedScene read(String name, InputStream in, String baseUrl) throws IOException {
    ProblemCollector problems = new ProblemCollector(binding.problems()::add);
    Scene scene = loader.load(name, in, SaiUrls.base(baseUrl), problems).scene();
    return checked(scene, problems, baseUrl);
  }

  private EmbeddedScene checked(Scene scene, ProblemCollector problems, String worldUrl) {
    if (scene.root().nodes("children").isEmpty() && problems.any()) {
      throw new InvalidX3DException(
          problems.list().get(0).location().file() + " holds no scene that can be read");
    }
    return new EmbeddedScene(binding, this, scene, worldUrl);
  }

  /** Reads the scene from the first of the URLs that can be read. */
  EmbeddedScene fromUrl(String[] urls) {
    String reason = "no address is given";
    for (String url : urls) {
      try {
        ProblemCollector problems = new ProblemCollector(binding.problems()::add);
        if (SaiUrls.isFile(url)) {
          Path file = SaiUrls.path(url);
          return checked(loader.load(file, problems).scene(), problems, SaiUrls.url(file));
        }
        return checked(loader.load(url, problems).scene(), problems, url);
      } catch (IOException e) {
        reason = String.valueOf(e.getMessage());
      }
    }
    throw new InvalidURLException(reason);
  }
}
