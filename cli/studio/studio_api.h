// The requests of the studio's page and their replies: docs/guides/studio.md lists them.
#pragma once

#include <atomic>
#include <string>

#include "cli/studio/loopback_server.h"
#include "cli/studio/studio_fruit.h"
#include "cli/studio/workspace.h"

namespace pomona {

class StudioApi {
 public:
  /// \param page the HTML of "/"
  StudioApi(Workspace& workspace, std::string page);

  /// Never throws: the reply tells the errors, each with its place in the template and in the drawing.
  WebReply answer(const WebRequest& request);

 private:
  WebReply routed(const WebRequest& request);
  WebReply document(bool with_texts);
  WebReply change(const std::string& body);
  WebReply save(const std::string& body);
  WebReply revert(const std::string& body);
  WebReply made(const WebRequest& request);
  WebReply section(const std::string& body);
  WebReply asset(const std::string& body);
  WebReply picture(const std::string& href) const;

  Workspace& workspace_;
  StudioFruits fruits_;
  std::string page_;
  std::atomic<int> at_work_ = 0;  ///< running requests that grow a fruit or read a picture
};

}  // namespace pomona
