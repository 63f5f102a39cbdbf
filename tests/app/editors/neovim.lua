-- A session of a person with Neovim: opens the project's file, reads what is wrong, types, asks, renames, lays out.
-- Ends with code 0 and "all good", or says what was otherwise and ends with code 1.
local function fail(what) io.stderr:write(what .. "\n"); vim.cmd("cquit 1") end
local function wait_for(what, condition)
  if not vim.wait(60000, condition, 10) then fail("timed out: " .. what) end
end
local function expect(what, ok) if not ok then fail("failed: " .. what) end end
local function ask(method, line, character, more)
  local params = { textDocument = vim.lsp.util.make_text_document_params(0), position = { line = line, character = character } }
  for key, value in pairs(more or {}) do params[key] = value end
  local answers = vim.lsp.buf_request_sync(0, method, params, 60000)
  for _, answer in pairs(answers or {}) do
    if answer.error then fail(method .. ": " .. answer.error.message) end
    return answer.result
  end
  fail("no answer to " .. method)
end
local function first_error()
  return vim.diagnostic.get(0, { severity = vim.diagnostic.severity.ERROR })[1]
end

local ok, problem = pcall(function()
  vim.cmd("edit src/main.st")
  wait_for("the server is attached", function() return next(vim.lsp.buf_get_clients(0)) ~= nil end)
  wait_for("the server is initialised", function() return vim.lsp.get_client_by_id(Stepwise).initialized end)
  vim.api.nvim_buf_set_text(0, 6, 14, 6, 19, { "lvel" }) -- a slip of the finger
  wait_for("the slip is reported", function() return first_error() ~= nil end)
  local slip = first_error()
  expect("the slip's place", slip.lnum == 6 and slip.col == 14)
  vim.api.nvim_buf_set_text(0, 6, 14, 6, 18, { "level" })
  wait_for("the slip is gone", function() return first_error() == nil end)

  expect("hover", ask("textDocument/hover", 6, 15).contents.value:find("level : INT", 1, true))
  expect("definition", ask("textDocument/definition", 2, 12).uri:find("src/pump.st", 1, true))
  local items = ask("textDocument/completion", 7, 8).items
  local found = false
  for _, item in ipairs(items) do found = found or item.label == "isRunning" end
  expect("completion", found)

  vim.lsp.util.apply_workspace_edit(ask("textDocument/rename", 7, 10, { newName = "runs" }), "utf-16")
  expect("rename here", vim.api.nvim_buf_get_lines(0, 7, 8, false)[1] == "IF pump.runs THEN")
  local other = vim.api.nvim_buf_get_lines(vim.fn.bufnr("src/pump.st"), 9, 10, false)[1]
  expect("rename there: " .. tostring(other), other == "runs := start AND speed > 0;")
  vim.api.nvim_buf_set_lines(0, 8, 9, false, { "hours:=hours+0.01;" })
  vim.lsp.util.apply_text_edits(
    ask("textDocument/formatting", 0, 0, { options = { tabSize = 4, insertSpaces = true } }), 0, "utf-16")
  expect("layout", vim.api.nvim_buf_get_lines(0, 8, 9, false)[1] == "    hours := hours + 0.01;")
  vim.cmd("silent wall")
end)
if not ok then fail(tostring(problem)) end
print("all good")
vim.cmd("qall!")
